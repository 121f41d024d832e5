#pragma once

// What marked pixels are hatched with. Patterns differ in shape and not in colour: rising lines,
// falling lines, dots; where several hold, they lie over each other. Each line is light beside
// dark, so that it is seen on any colour.

#include <QRectF>
#include <QRgb>
#include <QString>

#include "src/app/document/pixel_marks.h"

class QPainter;

namespace cutis {

struct HatchPattern {
  // Of device pixels; ratio: how many make a device-independent one.
  explicit HatchPattern(double ratio);

  // Transparent between the lines. Precondition: x and y are not negative.
  QRgb at(PixelMarks marks, int x, int y) const;

  int lines, dots, line;  // how far apart they are, and how wide a line is
};

// "Not like skin", …
QString markText(PixelMark mark);

// A sample of the pattern for a legend, in device-independent pixels.
void drawHatchSample(QPainter& painter, const QRectF& area, PixelMark mark);

}  // namespace cutis
