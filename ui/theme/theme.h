#pragma once

// The look of the editor: dark and neutral, so that the colours of skin are judged against grey of
// middle-dark lightness (L* about 22) and against nothing coloured but the accent.
//
// Widgets take colours from QPalette where it has a role, else from tones(). Interface thread only.
// Lengths are in device-independent pixels.

#include <QColor>
#include <QRectF>

class QApplication;
class QFont;
class QFormLayout;
class QLabel;
class QPainter;
class QWidget;

namespace cutis::theme {

struct Tones {
  QColor surround;  // around and behind the picture
  QColor panel;     // docks and strips
  QColor field;     // what is typed into, plots, thumbnails: darker than the panel
  QColor raised;    // buttons
  QColor line;      // separators and axes
  QColor control;   // grooves, check boxes, edges of fields: at least 3 : 1 on panel, field, raised
  QColor text;      // at least 4.5 : 1 on panel, field and raised, as all texts
  QColor dimText;   // secondary text, at least 4.5 : 1 on panel and field
  QColor accent;    // focus, selection, progress
  QColor original;  // curve of the original skin
  QColor edited;    // curve of the edited skin
  QColor error;
  QColor plotBand;  // what a plot is about, and what lies beside it
  QColor plotOuterBand;
  QColor gridLine;
};

// The tones of the theme in use.
const Tones& tones();

inline constexpr int kSpace = 8;
inline constexpr int kHalfSpace = 4;
inline constexpr int kDoubleSpace = 16;
inline constexpr int kCornerRadius = 4;
// The width of the labels before the fields of a panel: the fields of all panels stand in one line.
inline constexpr int kLabelWidth = 56;

// Style, palette and style sheet of the whole program. Call once, before the first widget.
void apply(QApplication& application);

// A form of a panel: no margins, fields in line with those of the other panels. Call it last.
void alignForm(QFormLayout& form);

// Derived from the widget's own font, so that a larger system font carries through.
QFont smallFont(const QWidget& widget);
QFont headingFont(const QWidget& widget);

// In the tone of secondary text, whatever the label had before.
void dimText(QLabel& label);

// What every control that draws itself shows when it has the keyboard.
void drawFocusRing(QPainter& painter, const QRectF& rect);

}  // namespace cutis::theme
