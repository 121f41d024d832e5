#include "ui/view/view_geometry.h"

#include <algorithm>
#include <cmath>

namespace cutis {
namespace {

// Device pixels of the picture that panning cannot push out of view.
constexpr double kStripInView = 48;
// The least side of a fitted picture, however long and narrow it is.
constexpr double kLeastSide = 4;

int roundedDown(double value, int multiple) {
  return static_cast<int>(std::floor(value / multiple)) * multiple;
}

}  // namespace

void ViewGeometry::setPicture(QSize pixels) {
  picture_ = pixels;
  fit();
}

void ViewGeometry::setView(QSize devicePixels, double margin) {
  const QPointF centre = toImage(middle());
  const bool first = view_.isEmpty();
  view_ = devicePixels;
  margin_ = margin;
  if (fitted_ || first) {
    if (fitted_) fit();
    return;
  }
  set(scale_, centre - middle() / scale_);
}

double ViewGeometry::fittedScale() const {
  const double width = std::max(view_.width() - 2 * margin_, 1.0);
  const double height = std::max(view_.height() - 2 * margin_, 1.0);
  const double whole = std::min(width / picture_.width(), height / picture_.height());
  const double seen = kLeastSide / std::min(picture_.width(), picture_.height());
  return std::min(std::max(whole, seen), kLargestScale);
}

void ViewGeometry::fit() {
  fitted_ = true;
  if (!hasPicture()) return;
  const double scale = fittedScale();
  set(scale, QPointF(picture_.width(), picture_.height()) / 2 - middle() / scale);
}

void ViewGeometry::zoomTo(double scale, const QPointF& anchor) {
  if (!hasPicture()) return;
  const double least = std::min(fittedScale() * kSmallestFit, 1.0);
  const double next = std::clamp(scale, least, kLargestScale);
  const QPointF kept = toImage(anchor);
  fitted_ = false;
  set(next, kept - anchor / next);
}

void ViewGeometry::zoomBy(double factor, const QPointF& anchor) {
  const double next = scale_ * factor;
  const bool passes = (scale_ < 1 && next > 1) || (scale_ > 1 && next < 1);
  zoomTo(passes ? 1.0 : next, anchor);
}

void ViewGeometry::pan(const QPointF& delta) {
  if (!hasPicture()) return;
  const auto kept = [this](double wanted, double now, int picture, int view) {
    const double strip = std::min(kStripInView, picture * scale_) / scale_;
    const double least = strip - view / scale_;
    const double most = picture - strip;
    // A picture that zooming has already put further out may stay, not go further.
    return std::clamp(wanted, std::min(least, now), std::max(most, now));
  };
  const QPointF wanted = origin_ - delta / scale_;
  fitted_ = false;
  set(scale_, {kept(wanted.x(), origin_.x(), picture_.width(), view_.width()),
               kept(wanted.y(), origin_.y(), picture_.height(), view_.height())});
}

void ViewGeometry::set(double scale, const QPointF& origin) {
  scale_ = scale;
  // At 1 : 1 every image pixel is one device pixel, not a mix of four.
  origin_ = scale == 1 ? QPointF(std::round(origin.x()), std::round(origin.y())) : origin;
}

int ViewGeometry::step() const {
  // A hair of slack, so that exactly one half is a step of 2.
  return std::max(1, static_cast<int>(std::floor(1 / scale_ + 1e-9)));
}

Rect ViewGeometry::visible() const {
  if (!hasPicture()) return {};
  const QPointF from = toImage({0, 0});
  const QPointF to = toImage({double(view_.width()), double(view_.height())});
  const Rect picture = {0, 0, picture_.width(), picture_.height()};
  const Rect view = {roundedDown(from.x(), step()), roundedDown(from.y(), step()),
                     static_cast<int>(std::ceil(to.x())), static_cast<int>(std::ceil(to.y()))};
  const Rect seen = intersection(picture, view);
  return seen.empty() ? Rect() : seen;
}

}  // namespace cutis
