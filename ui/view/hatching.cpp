#include "ui/view/hatching.h"

#include <cstddef>
#include <functional>
#include <vector>

#include "ui/color/hatch_pattern.h"
#include "ui/view/view_geometry.h"

namespace cutis {
namespace {

// Which sample stands under each device pixel of a side; -1: none.
std::vector<int> samplesAlong(int pixels, int from, int to, int step,
                              const std::function<double(double)>& imageAt) {
  std::vector<int> samples(static_cast<std::size_t>(pixels), -1);
  for (int i = 0; i < pixels; ++i) {
    const double image = imageAt(i + 0.5);
    if (image >= from && image < to)
      samples[static_cast<std::size_t>(i)] = static_cast<int>((image - from) / step);
  }
  return samples;
}

}  // namespace

QImage hatchLayer(const MarkedSamples& samples, const ViewGeometry& geometry, QSize size,
                  double ratio) {
  QImage layer(size, QImage::Format_ARGB32_Premultiplied);
  layer.fill(Qt::transparent);
  if (samples.marks.empty()) return layer;
  const Rect& part = samples.covered;
  const auto columns = samplesAlong(size.width(), part.x0, part.x1, samples.step, [&](double x) {
    return geometry.toImage({x, 0.0}).x();
  });
  const auto rows = samplesAlong(size.height(), part.y0, part.y1, samples.step, [&](double y) {
    return geometry.toImage({0.0, y}).y();
  });
  const int width = (part.width() + samples.step - 1) / samples.step;
  const HatchPattern pattern(ratio);
  for (int y = 0; y < size.height(); ++y) {
    const int row = rows[static_cast<std::size_t>(y)];
    if (row < 0) continue;
    const auto* marks = samples.marks.data() + std::ptrdiff_t{row} * width;
    auto* line = reinterpret_cast<QRgb*>(layer.scanLine(y));
    for (int x = 0; x < size.width(); ++x) {
      const int column = columns[static_cast<std::size_t>(x)];
      if (column >= 0 && marks[column] != 0) line[x] = pattern.at(marks[column], x, y);
    }
  }
  return layer;
}

}  // namespace cutis
