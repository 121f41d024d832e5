#include "ui/theme/theme.h"

#include <algorithm>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QEvent>
#include <QFont>
#include <QFormLayout>
#include <QLabel>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <QWidget>

#include "ui/theme/tool_tips.h"

namespace cutis::theme {
namespace {

Tones darkTones() {
  Tones tones;
  tones.surround = QColor(0x35, 0x35, 0x35);  // L* 22
  tones.panel = QColor(0x2b, 0x2b, 0x2b);
  tones.field = QColor(0x1e, 0x1e, 0x1e);
  tones.raised = QColor(0x3c, 0x3c, 0x3c);
  tones.line = QColor(0x4a, 0x4a, 0x4a);
  tones.control = QColor(0x8a, 0x8a, 0x8a);
  tones.text = QColor(0xdc, 0xdc, 0xdc);
  tones.dimText = QColor(0xa2, 0xa2, 0xa2);
  tones.accent = QColor(0x6f, 0xa8, 0xdc);
  tones.original = QColor(0x8f, 0xbf, 0xea);
  tones.edited = QColor(0xf5, 0xa7, 0x4f);
  tones.error = QColor(0xf0, 0x82, 0x6a);
  tones.plotBand = QColor(0x24, 0x24, 0x24);
  tones.plotOuterBand = QColor(0x1a, 0x1a, 0x1a);
  tones.gridLine = QColor(0x38, 0x38, 0x38);
  return tones;
}

constexpr int kSeparator = 5;      // between docks
constexpr int kTitleButton = 20;   // of docks
constexpr int kFloatingFrame = 1;  // around docks that float

QPalette paletteOf(const Tones& tones) {
  QPalette palette(tones.raised, tones.panel);
  palette.setColor(QPalette::Window, tones.panel);
  palette.setColor(QPalette::WindowText, tones.text);
  palette.setColor(QPalette::Base, tones.field);
  palette.setColor(QPalette::AlternateBase, tones.panel);
  palette.setColor(QPalette::Text, tones.text);
  palette.setColor(QPalette::Button, tones.raised);
  palette.setColor(QPalette::ButtonText, tones.text);
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, QColor(0x14, 0x14, 0x14));
  palette.setColor(QPalette::ToolTipText, tones.text);
  palette.setColor(QPalette::PlaceholderText, tones.dimText);
  palette.setColor(QPalette::Highlight, tones.accent);
  palette.setColor(QPalette::HighlightedText, QColor(0x10, 0x10, 0x10));
  palette.setColor(QPalette::Link, tones.accent);
  palette.setColor(QPalette::LinkVisited, tones.accent);
  const QColor off(0x78, 0x78, 0x78);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, off);
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, tones.line);
  palette.setColor(QPalette::Disabled, QPalette::HighlightedText, off);
  return palette;
}

// As flat as the buttons of the style sheet, which cannot draw an arrow without a picture file.
void drawComboBox(QPainter& painter, const QStyleOptionComboBox& box) {
  const bool enabled = box.state & QStyle::State_Enabled;
  const bool lit = enabled && box.state & QStyle::State_MouseOver;
  const QRectF frame = QRectF(box.rect).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(tones().line);
  painter.setBrush(lit ? QColor(0x47, 0x47, 0x47) : tones().raised);
  painter.drawRoundedRect(frame, kCornerRadius, kCornerRadius);
  const QPointF tip(frame.right() - 11, frame.center().y() + 2.5);
  painter.setPen(QPen(enabled ? tones().dimText : tones().line, 1.6, Qt::SolidLine, Qt::RoundCap));
  painter.drawPolyline(QPolygonF({tip + QPointF(-4, -4), tip, tip + QPointF(4, -4)}));
  painter.restore();
  if (box.state & QStyle::State_HasFocus) drawFocusRing(painter, QRectF(box.rect));
}

// Fusion draws an edge that a dark theme hides.
void drawCheckBox(QPainter& painter, const QStyleOption& option) {
  const bool isOn = option.state & QStyle::State_On;
  const bool isEnabled = option.state & QStyle::State_Enabled;
  const QColor edge = isEnabled ? tones().control : tones().line;
  const qreal side = std::min(option.rect.width(), option.rect.height()) - 1;
  QRectF box(0, 0, side, side);
  box.moveCenter(QRectF(option.rect).center());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(isOn && isEnabled ? tones().accent : edge, 1));
  painter.setBrush(isOn && isEnabled ? tones().accent : tones().field);
  painter.drawRoundedRect(box, 3, 3);
  const QPointF middle = box.center();
  painter.setPen(QPen(isEnabled ? QColor(0x10, 0x10, 0x10) : edge, side / 7, Qt::SolidLine,
                      Qt::RoundCap, Qt::RoundJoin));
  if (option.state & QStyle::State_NoChange) {
    painter.setPen(QPen(edge, side / 7, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(middle - QPointF(side / 4, 0), middle + QPointF(side / 4, 0));
  } else if (isOn) {
    painter.drawPolyline(
        QPolygonF({middle + QPointF(-0.27, 0.02) * side, middle + QPointF(-0.06, 0.23) * side,
                   middle + QPointF(0.28, -0.22) * side}));
  }
  painter.restore();
}

// Titles of docks are headings, as in a panel that cannot move.
void drawDockTitle(QPainter& painter, const QStyleOptionDockWidget& dock, const QWidget* widget) {
  painter.save();
  painter.fillRect(dock.rect, tones().panel);
  if (widget != nullptr) painter.setFont(headingFont(*widget));
  const QRect place = dock.rect.adjusted(kDoubleSpace, 0, -kDoubleSpace, 0);
  painter.setPen(tones().text);
  painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(dock.title, Qt::ElideRight,
                                                    place.width() - 2 * kTitleButton));
  painter.restore();
}

// A line between docks that lights up where it can be dragged.
void drawSeparator(QPainter& painter, const QStyleOption& option) {
  const bool lit = option.state & QStyle::State_MouseOver;
  painter.fillRect(option.rect, tones().panel);
  const bool isUpright = option.rect.width() < option.rect.height();
  const QPoint middle = option.rect.center();
  const QRect line = isUpright ? QRect(middle.x(), option.rect.top(), 1, option.rect.height())
                               : QRect(option.rect.left(), middle.y(), option.rect.width(), 1);
  painter.fillRect(line, lit ? tones().accent : tones().field);
}

// A dock that floats stands out from the picture below it.
void drawFloatingFrame(QPainter& painter, const QRect& rect) {
  painter.save();
  painter.setPen(QPen(tones().dimText, kFloatingFrame));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5));
  painter.restore();
}

// Drawn, so that they are sharp at 1.5 × and their grey is that of the theme.
QIcon titleIcon(QStyle::StandardPixmap which) {
  QIcon icon;
  for (const int size : {16, 24, 32}) {
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(size / 16.0, size / 16.0);
    painter.setPen(QPen(tones().dimText, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (which == QStyle::SP_TitleBarCloseButton) {
      painter.drawLine(QPointF(4.5, 4.5), QPointF(11.5, 11.5));
      painter.drawLine(QPointF(4.5, 11.5), QPointF(11.5, 4.5));
    } else {
      painter.drawRect(QRectF(3.5, 6.5, 6, 6));
      painter.drawPolyline(
          QPolygonF({{6.5, 6.5}, {6.5, 3.5}, {12.5, 3.5}, {12.5, 9.5}, {9.5, 9.5}}));
    }
    icon.addPixmap(pixmap);
  }
  return icon;
}

// Fusion hints at the focus too faintly for a dark theme.
class Style : public QProxyStyle {
 public:
  Style() : QProxyStyle(QStyleFactory::create("Fusion")) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    if (element == PE_IndicatorDockWidgetResizeHandle) {
      drawSeparator(*painter, *option);
    } else if (element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck) {
      drawCheckBox(*painter, *option);
    } else if (element == PE_FrameDockWidget) {
      drawFloatingFrame(*painter, option->rect);
    } else if (element != PE_FrameFocusRect) {
      QProxyStyle::drawPrimitive(element, option, painter, widget);
    } else if (option->state & State_KeyboardFocusChange) {
      drawFocusRing(*painter, QRectF(option->rect));
    }
  }

  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                          QPainter* painter, const QWidget* widget) const override {
    const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
    if (control == CC_ComboBox && box && !box->editable) {
      drawComboBox(*painter, *box);
    } else {
      QProxyStyle::drawComplexControl(control, option, painter, widget);
    }
  }

  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override {
    const auto* dock = qstyleoption_cast<const QStyleOptionDockWidget*>(option);
    if (element == CE_DockWidgetTitle && dock) {
      drawDockTitle(*painter, *dock, widget);
    } else {
      QProxyStyle::drawControl(element, option, painter, widget);
    }
  }

  QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                     const QWidget* widget) const override {
    const bool ofTitle = which == SP_TitleBarCloseButton || which == SP_TitleBarNormalButton;
    return ofTitle ? titleIcon(which) : QProxyStyle::standardIcon(which, option, widget);
  }

  using QProxyStyle::polish;

  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override {
    if (metric == PM_DockWidgetSeparatorExtent) return kSeparator;
    if (metric == PM_DockWidgetFrameWidth) return kFloatingFrame;
    if (metric == PM_DockWidgetTitleMargin) return kHalfSpace;
    if (metric == PM_DockWidgetTitleBarButtonMargin) return 1;
    return QProxyStyle::pixelMetric(metric, option, widget);
  }

  // The wheel scrolls past fields of numbers, too; it steps the one that has the keyboard.
  void polish(QWidget* widget) override {
    QProxyStyle::polish(widget);
    if (qobject_cast<QAbstractSpinBox*>(widget) == nullptr) return;
    widget->setFocusPolicy(Qt::StrongFocus);
    widget->installEventFilter(this);
  }

  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool passes =
        event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus();
    if (passes) return QProxyStyle::eventFilter(watched, event);
    event->ignore();
    return true;
  }

  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* result) const override {
    // The wheel scrolls the panel and chooses nothing on its way.
    if (hint == SH_ComboBox_AllowWheelScrolling) return 0;
    // A shadow below what is disabled reads as blur.
    if (hint == SH_EtchDisabledText || hint == SH_DitherDisabledText) return 0;
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
    // Lists follow the arrow keys and one click everywhere.
    if (hint == SH_ItemView_ActivateItemOnSingleClick) return 0;
    return QProxyStyle::styleHint(hint, option, widget, result);
  }
};

// Fusion's gloss and gradients are lights beside the picture: buttons, bars and lists are flat
// here.
constexpr const char* kStyleSheet = R"(
QToolTip { color: @text; background: #141414; border: 1px solid @line; padding: 4px; }
QPushButton { color: @text; background: @raised; border: 1px solid @line; border-radius: 4px;
  padding: 4px 12px; }
QMenuBar QPushButton { padding: 1px 12px; }
QPushButton:hover { background: #474747; }
QPushButton:pressed { background: @field; }
QPushButton:disabled { color: #787878; background: transparent; border-color: #3a3a3a; }
QPushButton:focus { border: 2px solid @accent; padding: 3px 11px; outline: none; }
QMenuBar QPushButton:focus { padding: 0 11px; }
QPushButton[primary="true"] { color: #101010; background: @accent; border-color: @accent; }
QPushButton[primary="true"]:hover { background: #86b8e6; }
QPushButton[primary="true"]:pressed { background: #5a92c6; }
QPushButton[primary="true"]:disabled { color: #787878; background: transparent;
  border-color: #3a3a3a; }
QPushButton[primary="true"]:focus { border: 2px solid @text; outline: none; }
QToolButton[segment="true"] { color: @dim; background: @field; border: 1px solid @line;
  padding: 4px 6px; }
QToolButton[segment="true"]:hover { color: @text; }
QToolButton[segment="true"]:checked { color: @text; background: @raised;
  border-bottom: 2px solid @accent; padding-bottom: 3px; }
QToolButton[segment="true"]:focus { border: 2px solid @accent; padding: 3px 5px; outline: none; }
QLineEdit { color: @text; background: @field; border: 1px solid @control; border-radius: 4px;
  padding: 1px 4px; }
QLineEdit:focus { border: 2px solid @accent; padding: 0 3px; }
QLineEdit:disabled { color: #787878; border-color: @line; }
QLineEdit[refused="true"] { border: 2px solid @error; padding: 0 3px; }
QAbstractSpinBox QLineEdit, QComboBox QLineEdit { border: none; padding: 0; }
QPushButton::menu-indicator { subcontrol-origin: padding; subcontrol-position: center right;
  right: 6px; }
QPushButton[menu="true"] { padding-right: 24px; }
QFrame#palette { border: 1px solid @control; border-radius: 4px; }
QListView, QTreeView { border: 2px solid transparent; }
QListView:focus, QTreeView:focus { border-color: @accent; }
QTabBar { qproperty-drawBase: 0; }
QTabBar::tab { color: @dim; background: transparent; border: none;
  border-bottom: 2px solid transparent; padding: 4px 12px; }
QTabBar::tab:hover { color: @text; }
QTabBar::tab:selected { color: @text; border-bottom: 2px solid @accent; }
QTabBar::tab:focus { border: 2px solid @accent; padding: 2px 10px; }
QProgressBar { background: @field; border: 1px solid @line; border-radius: 4px; }
QProgressBar::chunk { background: @accent; border-radius: 3px; }
QScrollBar:vertical { background: transparent; width: 8px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 8px; margin: 0; }
QScrollBar::handle { background: #565656; border-radius: 3px; margin: 1px; }
QScrollBar::handle:vertical { min-height: 32px; }
QScrollBar::handle:horizontal { min-width: 32px; }
QScrollBar::handle:hover { background: #6e6e6e; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
)";

QString styleSheetOf(const Tones& tones) {
  QString sheet = kStyleSheet;
  sheet.replace("@text", tones.text.name());
  sheet.replace("@dim", tones.dimText.name());
  sheet.replace("@line", tones.line.name());
  sheet.replace("@control", tones.control.name());
  sheet.replace("@error", tones.error.name());
  sheet.replace("@raised", tones.raised.name());
  sheet.replace("@field", tones.field.name());
  sheet.replace("@accent", tones.accent.name());
  return sheet;
}

}  // namespace

const Tones& tones() {
  static const Tones dark = darkTones();
  return dark;
}

void apply(QApplication& application) {
  QApplication::setStyle(new Style);
  QApplication::setPalette(paletteOf(tones()));
  application.setStyleSheet(styleSheetOf(tones()));
  new ToolTips(&application);
}

void alignForm(QFormLayout& form) {
  form.setContentsMargins(0, 0, 0, 0);
  form.setSpacing(kSpace);
  form.setLabelAlignment(Qt::AlignLeft);
  for (int row = 0; row < form.rowCount(); ++row) {
    const QLayoutItem* label = form.itemAt(row, QFormLayout::LabelRole);
    if (label) label->widget()->setMinimumWidth(kLabelWidth);
  }
}

QFont smallFont(const QWidget& widget) {
  QFont font = widget.font();
  if (font.pointSizeF() > 0) font.setPointSizeF(font.pointSizeF() * 0.9);
  return font;
}

QFont headingFont(const QWidget& widget) {
  QFont font = widget.font();
  font.setBold(true);
  return font;
}

void dimText(QLabel& label) {
  QPalette palette = label.palette();
  palette.setColor(QPalette::WindowText, tones().dimText);
  label.setPalette(palette);
}

void drawFocusRing(QPainter& painter, const QRectF& rect) {
  constexpr qreal kWidth = 2;
  const qreal inset = kWidth / 2;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(tones().accent, kWidth));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(rect.adjusted(inset, inset, -inset, -inset), kCornerRadius - 1,
                          kCornerRadius - 1);
  painter.restore();
}

}  // namespace cutis::theme
