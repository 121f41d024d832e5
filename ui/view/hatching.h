#pragma once  // internal to ui/view

// Hatching over samples that are marked: what is not skin, stands at a bound, or was not measured.
//
// Patterns are painted in pixels of the screen and keep their size at any zoom.

#include <vector>

#include <QImage>
#include <QSize>

#include "core/base/rect.h"
#include "src/app/document/pixel_marks.h"

namespace cutis {

class ViewGeometry;

// Samples of a part of the picture, one for each `step` pixels of `covered`, row by row.
struct MarkedSamples {
  std::vector<PixelMarks> marks;  // empty: none
  Rect covered;                   // image pixels
  int step = 1;
};

// A layer in device pixels of a view of this size, transparent where nothing is marked. Cost: the
// pixels of the view, some milliseconds for a large screen. ratio: device pixels per
// device-independent one.
QImage hatchLayer(const MarkedSamples& samples, const ViewGeometry& geometry, QSize size,
                  double ratio);

}  // namespace cutis
