#include "ui/view/viewport.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QPainter>

#include "ui/color/color_bar_control.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr double kFitMargin = 12;  // device-independent pixels

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

void Viewport::setMarkers(const QVector<PictureMarker>& markers) {
  if (markers == markers_) return;
  markers_ = markers;
  if (dragged_ && *dragged_ >= markers_.size()) dragged_.reset();
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

std::optional<int> Viewport::markerUnder(const QPointF& widget) const {
  const QPointF point = split_.intoFirst(widget, width());
  return markerAt(markers_, point, [this](const QPointF& image) { return toWidget(image); });
}

// Where the mouse is beyond the picture the marker stays.
void Viewport::dragMarker(const QPointF& widget) {
  const auto pixel = pixelAt(widget);
  if (pixel && *pixel != markers_[*dragged_].pixel)
    Q_EMIT markerDragged(*dragged_, pixel->x(), pixel->y());
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
  } else if (dragged_ || (cursor_ && markerUnder(*cursor_))) {
    setCursor(Qt::SizeAllCursor);
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
  drawMarkersOnPanes(painter);
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

void Viewport::drawMarkersOnPanes(QPainter& painter) {
  const auto place = [this](const QPointF& image) { return toWidget(image); };
  if (split_.mode != SplitMode::sideBySide) return drawMarkers(painter, font(), markers_, place);
  const QSize pane = split_.paneOf(size());
  for (const int left : {0, pane.width()}) {
    painter.save();
    painter.translate(left, 0);
    painter.setClipRect(QRect(QPoint(), pane));
    drawMarkers(painter, font(), markers_, place);
    painter.restore();
  }
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

}  // namespace cutis
