#include "ui/widgets/neutral_slider.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr double kHandleRadius = 6.5;
constexpr double kGrooveHeight = 4;
constexpr double kPageStep = 0.25;
// QSlider counts in integers; they serve accessibility only.
constexpr int kPlaces = 2000;

double fineness(Qt::KeyboardModifiers modifiers) {
  return modifiers & Qt::ShiftModifier ? kFineStep : 1.0;
}

}  // namespace

NeutralSlider::NeutralSlider(const SliderScale& scale, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), scale_(scale), number_(scale.neutral) {
  setRange(0, kPlaces);
  place(scale.neutral);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFocusPolicy(Qt::StrongFocus);
}

void NeutralSlider::setNumber(double number) {
  if (number != number_) dragging_ = false;
  place(number);
}

void NeutralSlider::place(double number) {
  number_ = std::clamp(number, scale_.minimum, scale_.maximum);
  QSlider::setValue(static_cast<int>(std::lround(scale_.placeOf(number_) * kPlaces)));
  update();
}

QSize NeutralSlider::sizeHint() const {
  return {160, 22};
}
QSize NeutralSlider::minimumSizeHint() const {
  return {80, 22};
}

void NeutralSlider::moveTo(double value, SliderMotion motion) {
  const double before = number_;
  place(value);
  if (number_ != before) Q_EMIT valueMoved(number_, motion);
}

// Where the middle of the handle runs.
QRectF NeutralSlider::groove() const {
  const double inset = kHandleRadius + 1.5;
  return {inset, height() / 2.0 - kGrooveHeight / 2, width() - 2 * inset, kGrooveHeight};
}

void NeutralSlider::paintEvent(QPaintEvent*) {
  const theme::Tones& tones = theme::tones();
  const QRectF track = groove();
  const double middle = track.center().x();
  const double x = track.left() + track.width() * scale_.placeOf(number_);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(tones.control);
  painter.drawRoundedRect(track, kGrooveHeight / 2, kGrooveHeight / 2);
  painter.setBrush(tones.dimText);
  painter.drawRect(QRectF(middle - 0.5, track.top() - 4, 1, kGrooveHeight + 8));
  if (isEnabled()) {
    painter.setBrush(tones.accent);
    painter.drawRect(QRectF(QPointF(std::min(x, middle), track.top()),
                            QPointF(std::max(x, middle), track.bottom())));
  }
  const bool lit = dragging_ || underMouse();
  painter.setBrush(!isEnabled() ? tones.line : lit ? QColor(Qt::white) : tones.text);
  painter.setPen(QPen(tones.field, 1));
  painter.drawEllipse(QPointF(x, track.center().y()), kHandleRadius, kHandleRadius);
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(tones.accent, 2));
    painter.drawEllipse(QPointF(x, track.center().y()), kHandleRadius + 0.5, kHandleRadius + 0.5);
  }
}

void NeutralSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  dragX_ = event->position().x();
  dragPlace_ = scale_.placeOf(number_);
  dragging_ = true;
  moved_ = false;
  update();
}

void NeutralSlider::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (!dragging_ || x == dragX_) return;
  dragPlace_ += (x - dragX_) / groove().width() * fineness(event->modifiers());
  dragX_ = x;
  moved_ = true;
  moveTo(scale_.valueAt(dragPlace_), SliderMotion::dragging);
}

void NeutralSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !dragging_) return;
  dragging_ = false;
  update();
  if (moved_) Q_EMIT valueMoved(number_, SliderMotion::done);
}

void NeutralSlider::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  dragging_ = false;
  moveTo(scale_.neutral, SliderMotion::done);
}

void NeutralSlider::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();
  // With shift some platforms turn the wheel sideways.
  const QPoint turned = event->angleDelta();
  const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
  moveTo(number_ + notches * kSliderStep * fineness(event->modifiers()), SliderMotion::stepping);
  event->accept();
}

void NeutralSlider::keyPressEvent(QKeyEvent* event) {
  const double step = kSliderStep * fineness(event->modifiers());
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
      return moveTo(number_ - step, SliderMotion::stepping);
    case Qt::Key_Right:
    case Qt::Key_Up:
      return moveTo(number_ + step, SliderMotion::stepping);
    case Qt::Key_PageDown:
      return moveTo(number_ - kPageStep, SliderMotion::stepping);
    case Qt::Key_PageUp:
      return moveTo(number_ + kPageStep, SliderMotion::stepping);
    case Qt::Key_Home:
      return moveTo(scale_.minimum, SliderMotion::done);
    case Qt::Key_End:
      return moveTo(scale_.maximum, SliderMotion::done);
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return moveTo(scale_.neutral, SliderMotion::done);
    default:
      event->ignore();
  }
}

void NeutralSlider::enterEvent(QEnterEvent*) {
  update();
}
void NeutralSlider::leaveEvent(QEvent*) {
  update();
}

}  // namespace cutis
