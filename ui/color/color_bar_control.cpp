#include "ui/color/color_bar_control.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr double kStep = 0.02;
constexpr double kFineStep = 0.002;
constexpr double kLeastDistance = 0.01;  // between the handles, of the axis

}  // namespace

ColorBarControl::ColorBarControl(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::TabFocus);
  hide();
}

void ColorBarControl::setSpec(const std::optional<ColorBarSpec>& spec) {
  const std::vector<float> heights = spec_ ? spec_->heights : std::vector<float>();
  spec_ = spec;
  if (isHeld_ && canBeMoved()) {
    spec_->axis = heldAxis_;
    spec_->heights = heights;
  }
  if (!canBeMoved()) isHeld_ = false;
  setFocusPolicy(canBeMoved() ? Qt::TabFocus : Qt::NoFocus);
  setCursor(canBeMoved() ? Qt::SizeHorCursor : Qt::ArrowCursor);
  setAccessibleName(spec_ ? tr("Range of %1").arg(spec_->name) : QString());
  setToolTip(canBeMoved() ? tr("Drag the ends of the range; a double click makes it automatic")
                          : QString());
  layOut();
  update();
}

void ColorBarControl::setPlace(const QPointF& lowerLeft, const QSizeF& picture) {
  lowerLeft_ = lowerLeft;
  picture_ = picture;
  layOut();
}

void ColorBarControl::layOut() {
  places_ = spec_ ? placesOf(font(), picture_, *spec_) : ColorBarPlaces();
  setVisible(!places_.size.isEmpty());
  const QSize size(static_cast<int>(std::ceil(places_.size.width())),
                   static_cast<int>(std::ceil(places_.size.height())));
  setGeometry(QRect(
      QPoint(static_cast<int>(lowerLeft_.x()), static_cast<int>(lowerLeft_.y()) - size.height()),
      size));
}

double ColorBarControl::handlePosition(bool isMaximum) const {
  return PositionIn(*spec_->axis)(isMaximum ? spec_->range.maximum : spec_->range.minimum);
}

QPointF ColorBarControl::handleAt(bool isMaximum) const {
  if (!canBeMoved()) return {};
  const QRectF& colors = places_.colors;
  return {colors.left() + handlePosition(isMaximum) * colors.width(), colors.bottom()};
}

void ColorBarControl::moveHandle(double position) {
  const double other = handlePosition(!isMaximum_);
  DisplayRange range = spec_->range;
  if (isMaximum_) {
    range.maximum = valueAt(*spec_->axis, std::clamp(position, other + kLeastDistance, 1.0));
  } else {
    range.minimum = valueAt(*spec_->axis, std::clamp(position, 0.0, other - kLeastDistance));
  }
  if (range != spec_->range) Q_EMIT rangeMoved(range);
}

void ColorBarControl::paintEvent(QPaintEvent*) {
  if (!spec_) return;
  QPainter painter(this);
  drawColorBar(painter, font(), {0, double(height())}, picture_, *spec_);
  if (showFocus_) theme::drawFocusRing(painter, QRectF(rect()));
}

void ColorBarControl::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !canBeMoved()) return;
  const auto away = [&](bool isMaximum) {
    return std::abs(event->position().x() - handleAt(isMaximum).x());
  };
  isMaximum_ = away(true) <= away(false);
  isHeld_ = true;
  heldAxis_ = spec_->axis;
}

void ColorBarControl::mouseMoveEvent(QMouseEvent* event) {
  if (!isHeld_) return;
  const QRectF& colors = places_.colors;
  moveHandle((event->position().x() - colors.left()) / colors.width());
}

void ColorBarControl::mouseReleaseEvent(QMouseEvent*) {
  if (!isHeld_) return;
  isHeld_ = false;
  Q_EMIT rangeMoved(spec_->range);  // the axis follows it now
}

void ColorBarControl::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !canBeMoved()) return;
  isHeld_ = false;
  Q_EMIT automaticWanted();
}

void ColorBarControl::keyPressEvent(QKeyEvent* event) {
  if (!canBeMoved()) return QWidget::keyPressEvent(event);
  const double step = event->modifiers() & Qt::ShiftModifier ? kFineStep : kStep;
  switch (event->key()) {
    case Qt::Key_Left:
      return moveHandle(handlePosition(isMaximum_) - step);
    case Qt::Key_Right:
      return moveHandle(handlePosition(isMaximum_) + step);
    case Qt::Key_Up:
    case Qt::Key_Down:
      isMaximum_ = event->key() == Qt::Key_Up;
      return;
    case Qt::Key_Home:
      Q_EMIT automaticWanted();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void ColorBarControl::focusInEvent(QFocusEvent*) {
  showFocus_ = true;
  update();
}

void ColorBarControl::focusOutEvent(QFocusEvent*) {
  showFocus_ = false;
  update();
}

}  // namespace cutis
