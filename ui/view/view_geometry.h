#pragma once  // internal to ui/view

// Where the picture lies in the view: zoom, pan, fit, and which pixels are seen.
//
// Two frames: image pixels (the centre of pixel (0, 0) is at 0.5, 0.5) and device pixels of the
// view, from its upper left corner. scale() is device pixels per image pixel. Pure arithmetic: no
// widget, no event.

#include <QPointF>
#include <QSize>

#include "core/base/rect.h"

namespace cutis {

class ViewGeometry {
 public:
  static constexpr double kLargestScale = 64;
  // The smallest zoom shows the whole picture in this share of the fitted size.
  static constexpr double kSmallestFit = 1.0 / 8;

  // A new picture is fitted. Empty sizes mean that there is none.
  void setPicture(QSize pixels);
  // The size in device pixels. `margin` is kept free around a fitted picture. Keeps the fit, or
  // else the image point in the middle of the view.
  void setView(QSize devicePixels, double margin);

  bool hasPicture() const { return !picture_.isEmpty() && !view_.isEmpty(); }
  QSize picture() const { return picture_; }
  bool fitted() const { return fitted_; }
  double scale() const { return scale_; }

  // The whole picture, centred; stays so when the view changes its size. Of a picture so long and
  // narrow that it would be thinner than a few device pixels, the middle part.
  void fit();
  // Keeps the image point under `anchor` (device pixels) where it is.
  void zoomTo(double scale, const QPointF& anchor);
  // zoomTo that halts at 1 : 1 on its way past it: a wheel finds the sharp picture.
  void zoomBy(double factor, const QPointF& anchor);
  // Moves the picture by device pixels; a strip of it stays in view.
  void pan(const QPointF& delta);

  QPointF toImage(const QPointF& device) const { return device / scale_ + origin_; }
  QPointF toDevice(const QPointF& image) const { return (image - origin_) * scale_; }
  QPointF middle() const { return {view_.width() / 2.0, view_.height() / 2.0}; }

  // The largest step between sampled pixels that leaves at least one sample per device pixel.
  int step() const;
  // The pixels in view, cut to the picture, the upper left corner on a multiple of step() so that
  // the same samples are taken wherever the picture is moved to. Empty if none is in view.
  Rect visible() const;

 private:
  double fittedScale() const;
  void set(double scale, const QPointF& origin);

  QSize picture_;
  QSize view_;
  double margin_ = 0;
  bool fitted_ = true;
  double scale_ = 1;
  QPointF origin_;  // the image point at the upper left corner of the view
};

}  // namespace cutis
