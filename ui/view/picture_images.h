#pragma once  // internal to ui/view

// What the view has of the picture: a coarse whole, and a part in detail above it.

#include <QImage>

#include "core/base/rect.h"

class QPainter;

namespace cutis {

class ViewGeometry;

struct PictureImages {
  QImage overview;  // the whole picture, stretched
  QImage detail;    // one sample per `step` pixels of `covered`, from its upper left corner
  Rect covered;     // image pixels
  int step = 1;

  // Paints what of the picture lies in `seen`, in device pixels of the view. Cost: the pixels in
  // view, whatever the size of the images. Smooth up to 2 ×, above it the detail's pixels are the
  // squares that they are.
  void draw(QPainter& painter, const ViewGeometry& geometry, const QRect& seen) const;
};

}  // namespace cutis
