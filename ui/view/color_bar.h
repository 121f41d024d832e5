#pragma once  // internal to ui/view

// The labelled colour bar that lies over a false-colour picture: the field's name and unit, the
// colours from minimum to maximum, and the numbers at both ends and the middle.

#include <QString>

#include "ui/view/color_scale.h"

class QFont;
class QPainter;
class QPointF;
class QRectF;
class QSizeF;

namespace cutis {

struct ColorBarSpec {
  QString name;        // "Melanin"
  QString unit;        // "volume fraction"; may be empty
  double minimum = 0;  // in the unit
  double maximum = 1;
  ScaleKind scale = ScaleKind::sequential;
  QString state = {};   // "Edited"; what the numbers leave open, may be empty
  bool isKnown = true;  // false: there is nothing that numbers could stand for yet

  bool operator==(const ColorBarSpec&) const = default;
};

// Draws with its lower left corner at the given point, on a backdrop of its own, over a picture of
// the given size. It covers a quarter of the picture at most: where that is small it leaves out the
// unit and the middle, and is left out where not even the name has room. Lengths in
// device-independent pixels. Returns what was covered.
QRectF drawColorBar(QPainter& painter, const QFont& font, const QPointF& lowerLeft,
                    const QSizeF& picture, const ColorBarSpec& spec);

}  // namespace cutis
