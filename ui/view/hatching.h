#pragma once  // internal to ui/view

// Hatching over samples that are marked: what is not skin, stands at a bound, or was not measured.
//
// Patterns differ in shape and not in colour: rising lines, falling lines, dots; where several
// hold, they lie over each other. Each line is light beside dark, so that it is seen on any colour.
// They are painted in pixels of the screen and keep their size at any zoom.

#include <vector>

#include <QImage>
#include <QRectF>
#include <QString>

#include "core/base/rect.h"
#include "src/app/document/pixel_marks.h"

class QPainter;

namespace cutis {

class ViewGeometry;

// Samples of a part of the picture, one for each `step` pixels of `covered`, row by row.
struct MarkedSamples {
  std::vector<PixelMarks> marks;  // empty: none
  Rect covered;                   // image pixels
  int step = 1;
};

// "Not like skin", …
QString markText(PixelMark mark);

// A layer in device pixels of a view of this size, transparent where nothing is marked. Cost: the
// pixels of the view, some milliseconds for a large screen. ratio: device pixels per
// device-independent one.
QImage hatchLayer(const MarkedSamples& samples, const ViewGeometry& geometry, QSize size,
                  double ratio);

// A sample of the pattern for a legend, in device-independent pixels.
void drawHatchSample(QPainter& painter, const QRectF& area, PixelMark mark);

}  // namespace cutis
