// Parts of ui/view/viewport.h: mouse, wheel and keyboard.

#include <cmath>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QStyleHints>
#include <QTextEdit>
#include <QWheelEvent>

#include "ui/view/viewport.h"

namespace cutis {
namespace {

constexpr double kArrowDistance = 64;  // device-independent pixels
constexpr double kNotch = 120;
constexpr double kWipeStep = 0.02;  // of the width

bool takesText(const QObject* widget) {
  return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
         qobject_cast<const QTextEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget);
}

}  // namespace

void Viewport::wheelEvent(QWheelEvent* event) {
  cursor_ = event->position();
  const double notches = event->angleDelta().y() / kNotch;
  if (notches != 0) zoomBy(std::pow(kZoomPerNotch, notches));
  event->accept();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  const bool pans =
      event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && spaceHeld_);
  if (pans) {
    grabbed_ = event->position();
    updateShape();
    return;
  }
  const bool isLeft = event->button() == Qt::LeftButton;
  if (isLeft && split_.isOnLine(event->position(), width())) {
    wiping_ = true;
    return;
  }
  const auto marker = markerUnder(event->position());
  if (marker && isLeft) dragged_ = marker;
  if (!marker && isLeft) pressed_ = event->position();
  if (marker && event->button() != Qt::MiddleButton) Q_EMIT markerPressed(*marker);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  cursor_ = event->position();
  if (grabbed_) {
    const QPointF moved = event->position() - *grabbed_;
    grabbed_ = event->position();
    geometry_.pan(moved * devicePixelRatioF());
    viewMoved();
    return;
  }
  if (wiping_) moveLine(event->position().x());
  if (dragged_) dragMarker(event->position());
  if (pressed_) {
    const int far = QGuiApplication::styleHints()->startDragDistance();
    if ((event->position() - *pressed_).manhattanLength() >= far) pressed_.reset();
  }
  updateShape();
  updateCursor();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (grabbed_) {
    grabbed_.reset();
    updateShape();
  } else if (wiping_ && event->button() == Qt::LeftButton) {
    wiping_ = false;
    updateShape();
  } else if (dragged_ && event->button() == Qt::LeftButton) {
    dragged_.reset();
    updateShape();
  } else if (pressed_ && event->button() == Qt::LeftButton) {
    const std::optional<QPoint> pixel = pixelAt(*pressed_);
    pressed_.reset();
    if (pixel) Q_EMIT clicked(pixel->x(), pixel->y());
  }
}

void Viewport::leaveEvent(QEvent*) {
  cursor_.reset();
  updateCursor();
}

// Another document comes to the front under a still cursor.
void Viewport::hideEvent(QHideEvent*) {
  cursor_.reset();
  updateCursor();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  const double far = kArrowDistance * devicePixelRatioF();
  const bool isSideways = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
  if (split_.mode == SplitMode::wipe && isSideways && event->modifiers() == Qt::ShiftModifier) {
    const double step = event->key() == Qt::Key_Left ? -kWipeStep : kWipeStep;
    return moveLine((split_.position + step) * width());
  }
  QPointF move;
  switch (event->key()) {
    case Qt::Key_Left:
      move = {far, 0};
      break;
    case Qt::Key_Right:
      move = {-far, 0};
      break;
    case Qt::Key_Up:
      move = {0, far};
      break;
    case Qt::Key_Down:
      move = {0, -far};
      break;
    case Qt::Key_Space:
      if (!event->isAutoRepeat()) setSpaceHeld(true);
      return;
    default:
      return QWidget::keyPressEvent(event);
  }
  geometry_.pan(move);
  viewMoved();
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space) return QWidget::keyReleaseEvent(event);
  if (!event->isAutoRepeat()) setSpaceHeld(false);
}

void Viewport::setSpaceHeld(bool held) {
  spaceHeld_ = held;
  updateShape();
}

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
  const bool isPress = event->type() == QEvent::KeyPress;
  if (!isPress && event->type() != QEvent::KeyRelease) return false;
  const auto* key = static_cast<const QKeyEvent*>(event);
  if (key->key() != Qt::Key_Space || watched == this || !watched->isWidgetType()) return false;
  const bool isWanted = isPress ? cursor_ && isActiveWindow() && !takesText(watched) : spaceHeld_;
  if (!isWanted) return false;
  if (!key->isAutoRepeat()) setSpaceHeld(isPress);
  return true;
}

// The release of the key goes to another window.
void Viewport::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ActivationChange && !isActiveWindow()) setSpaceHeld(false);
  QWidget::changeEvent(event);
}

void Viewport::focusInEvent(QFocusEvent* event) {
  showFocus_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  update();
}

void Viewport::focusOutEvent(QFocusEvent*) {
  showFocus_ = false;
  setSpaceHeld(false);  // its release goes elsewhere
  update();
}

}  // namespace cutis
