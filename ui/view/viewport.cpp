#include "ui/view/viewport.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPlainTextEdit>
#include <QStyleHints>
#include <QTextEdit>
#include <QWheelEvent>

#include "ui/color/color_bar_control.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr double kFitMargin = 12;      // device-independent pixels
constexpr double kArrowDistance = 64;  // device-independent pixels
// One notch of a wheel; a touchpad sends fractions of it.
constexpr double kZoomPerNotch = 1.25;
constexpr double kNotch = 120;
constexpr double kWipeStep = 0.02;  // of the width

bool takesText(const QObject* widget) {
  return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
         qobject_cast<const QTextEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget);
}

}  // namespace

Viewport::Viewport(QWidget* parent)
    : QWidget(parent), colorBar_(new ColorBarControl(this)), bandScrubber_(new BandScrubber(this)) {
  setAccessibleName(tr("Picture"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(160, 120);
  qApp->installEventFilter(this);
  connect(colorBar_, &ColorBarControl::rangeMoved, this, &Viewport::rangeMoved);
  connect(colorBar_, &ColorBarControl::automaticWanted, this, &Viewport::automaticRangeWanted);
}

void Viewport::setPictureSize(int width, int height) {
  images_ = {};
  split_.second = {};
  setMarks({});
  toldStep_ = 0;
  geometry_.setPicture({width, height});
  placeToShow_.reset();
  viewMoved();
}

void Viewport::setOverview(const QImage& image) {
  images_.overview = image;
  update();
}

void Viewport::setDetail(const QImage& image, const Rect& covered, int step) {
  images_.detail = image;
  images_.covered = covered;
  images_.step = std::max(step, 1);
  update();
}

void Viewport::clear() {
  setPictureSize(0, 0);
}

void Viewport::setSplit(SplitMode mode, const QString& firstName, const QString& secondName) {
  split_.firstName = firstName;
  split_.secondName = secondName;
  update();
  if (mode == split_.mode) return;
  split_.mode = mode;
  wiping_ = false;
  layOut();
}

void Viewport::setSecondOverview(const QImage& image) {
  split_.second.overview = image;
  update();
}

void Viewport::setSecondDetail(const QImage& image, const Rect& covered, int step) {
  split_.second.detail = image;
  split_.second.covered = covered;
  split_.second.step = std::max(step, 1);
  update();
}

void Viewport::clearSecond() {
  split_.second = {};
  update();
}

QImage Viewport::picture() {
  const bool hadFocus = std::exchange(showFocus_, false);
  const QSize pane = split_.paneOf(size());
  const QSize size = geometry_.picture();
  QRectF seen = QRectF(toWidget({0, 0}), toWidget(QPointF(size.width(), size.height()))) &
                QRectF(QPointF(), QSizeF(pane));
  if (split_.mode == SplitMode::sideBySide) seen |= seen.translated(pane.width(), 0);
  const QImage image = grab(seen.toAlignedRect()).toImage();
  showFocus_ = hadFocus;
  return image;
}

const std::optional<ColorBarSpec>& Viewport::colorBar() const {
  return colorBar_->spec();
}

void Viewport::setColorBar(const std::optional<ColorBarSpec>& spec) {
  if (spec == colorBar_->spec()) return;
  colorBar_->setSpec(spec);
  placeControls();
}

void Viewport::setMarks(const MarkedSamples& marks) {
  marks_ = marks;
  hatching_ = {};
  update();
}

void Viewport::setNotice(const QString& notice) {
  if (notice == notice_) return;
  notice_ = notice;
  setAccessibleDescription(notice);
  update();
}

QPointF Viewport::toWidget(const QPointF& image) const {
  return geometry_.toDevice(image) / devicePixelRatioF();
}

QPointF Viewport::toImage(const QPointF& widget) const {
  return geometry_.toImage(split_.intoFirst(widget, width()) * devicePixelRatioF());
}

void Viewport::fitPicture() {
  geometry_.fit();
  viewMoved();
}

void Viewport::zoomOneToOne() {
  geometry_.zoomTo(1, anchor());
  viewMoved();
}

void Viewport::zoomBy(double factor) {
  geometry_.zoomBy(factor, anchor());
  viewMoved();
}

void Viewport::showPlace(const QPointF& image, double zoom) {
  if (size().isEmpty() || !geometry_.hasPicture()) {
    placeToShow_ = {image, zoom};
    return;
  }
  geometry_.zoomTo(zoom, geometry_.middle());
  geometry_.pan(geometry_.middle() - geometry_.toDevice(image));
  viewMoved();
}

void Viewport::zoomIn() {
  zoomBy(kZoomPerNotch);
}

void Viewport::zoomOut() {
  zoomBy(1 / kZoomPerNotch);
}

QPointF Viewport::anchor() const {
  return cursor_ ? split_.intoFirst(*cursor_, width()) * devicePixelRatioF() : geometry_.middle();
}

std::optional<QPoint> Viewport::pixelAt(const QPointF& widget) const {
  if (!geometry_.hasPicture()) return {};
  const QPointF image = toImage(widget);
  const QPoint pixel(static_cast<int>(std::floor(image.x())),
                     static_cast<int>(std::floor(image.y())));
  if (!QRect(QPoint(0, 0), geometry_.picture()).contains(pixel)) return {};
  return pixel;
}

void Viewport::placeControls() {
  const QSize size = geometry_.picture();
  const QRectF picture(toWidget({0.0, 0.0}), toWidget(QPointF(size.width(), size.height())));
  colorBar_->setPlace({double{theme::kDoubleSpace}, double(height() - theme::kDoubleSpace)},
                      picture.intersected(QRectF(rect())).size());
  bandScrubber_->place(colorBar_->isVisibleTo(this) ? colorBar_->geometry().right() + 1 : 0,
                       this->size());
}

void Viewport::viewMoved() {
  update();
  hatching_ = {};
  placeControls();
  const Rect visible = geometry_.visible();
  const int step = geometry_.step();
  if (visible != toldVisible_ || step != toldStep_) {
    toldVisible_ = visible;
    toldStep_ = step;
    Q_EMIT viewChanged(visible, step);
  }
  // The picture has moved under a still cursor.
  updateCursor();
}

void Viewport::updateCursor() {
  const std::optional<QPoint> pixel = cursor_ ? pixelAt(*cursor_) : std::nullopt;
  if (pixel) {
    cursorOnPicture_ = true;
    Q_EMIT cursorMoved(pixel->x(), pixel->y());
  } else if (cursorOnPicture_) {
    cursorOnPicture_ = false;
    Q_EMIT cursorLeft();
  }
}

void Viewport::updateShape() {
  if (grabbed_) {
    setCursor(Qt::ClosedHandCursor);
  } else if (spaceHeld_) {
    setCursor(Qt::OpenHandCursor);
  } else if (wiping_ || (cursor_ && split_.isOnLine(*cursor_, width()))) {
    setCursor(Qt::SplitHCursor);
  } else {
    unsetCursor();
  }
}

void Viewport::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme::tones().surround);
  painter.save();
  painter.scale(1 / devicePixelRatioF(), 1 / devicePixelRatioF());
  split_.draw(painter, geometry_, images_, (QSizeF(size()) * devicePixelRatioF()).toSize());
  painter.restore();
  drawHatching(painter);
  split_.drawFrame(painter, font(), size());
  if (!notice_.isEmpty()) drawNotice(painter);
  if (showFocus_) theme::drawFocusRing(painter, QRectF(rect()));
}

void Viewport::drawHatching(QPainter& painter) {
  if (marks_.marks.empty() || !split_.showsFirst()) return;
  const double ratio = devicePixelRatioF();
  if (hatching_.isNull()) {
    hatching_ = hatchLayer(marks_, geometry_, (QSizeF(size()) * ratio).toSize(), ratio);
    hatching_.setDevicePixelRatio(ratio);
  }
  painter.save();
  if (split_.mode == SplitMode::wipe)
    painter.setClipRect(QRectF(0, 0, split_.lineAt(width()), height()));
  if (split_.mode == SplitMode::sideBySide)
    painter.setClipRect(QRect(QPoint(), split_.paneOf(size())));
  painter.drawImage(QPointF(0, 0), hatching_);
  painter.restore();
}

void Viewport::drawNotice(QPainter& painter) const {
  const QSize text = fontMetrics().size(0, notice_);
  QRectF box(QPointF(), text + QSize(2 * theme::kDoubleSpace, 2 * theme::kSpace));
  box.moveCenter(QRectF(rect()).center());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0x14, 0x14, 0x14, 0xd8));
  painter.drawRoundedRect(box, theme::kCornerRadius, theme::kCornerRadius);
  painter.setPen(theme::tones().text);
  painter.drawText(box, Qt::AlignCenter, notice_);
}

void Viewport::layOut() {
  const double ratio = devicePixelRatioF();
  geometry_.setView(split_.paneOf((QSizeF(size()) * ratio).toSize()), kFitMargin * ratio);
  viewMoved();
}

void Viewport::moveLine(double x) {
  split_.moveLineTo(x, width());
  update();
}

void Viewport::resizeEvent(QResizeEvent*) {
  layOut();
  if (const auto place = std::exchange(placeToShow_, {})) showPlace(place->first, place->second);
}

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
  } else if (event->button() == Qt::LeftButton && split_.isOnLine(event->position(), width())) {
    wiping_ = true;
  } else if (event->button() == Qt::LeftButton) {
    pressed_ = event->position();
  }
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
  updateShape();
  if (pressed_) {
    const int far = QGuiApplication::styleHints()->startDragDistance();
    if ((event->position() - *pressed_).manhattanLength() >= far) pressed_.reset();
  }
  updateCursor();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (grabbed_) {
    grabbed_.reset();
    updateShape();
  } else if (wiping_ && event->button() == Qt::LeftButton) {
    wiping_ = false;
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
