#include "ui/view/hatching.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include <QCoreApplication>
#include <QPainter>

#include "ui/view/view_geometry.h"

namespace cutis {
namespace {

constexpr QRgb kLight = 0xffffffff;
constexpr QRgb kDark = 0xff000000;
constexpr QRgb kClear = 0x00000000;
constexpr double kApartLines = 9;  // device-independent pixels, as below
constexpr double kApartDots = 6;
constexpr double kLine = 1;

// The patterns at one resolution of the screen.
struct HatchPattern {
  int lines, dots, line;

  explicit HatchPattern(double ratio)
      : lines(std::max(4, static_cast<int>(std::lround(kApartLines * ratio)))),
        dots(std::max(4, static_cast<int>(std::lround(kApartDots * ratio)))),
        line(std::max(1, static_cast<int>(std::lround(kLine * ratio)))) {}

  // Precondition: x and y are not negative.
  QRgb at(PixelMarks marks, int x, int y) const {
    QRgb color = kClear;
    const auto draw = [&](int place) {
      if (place < line) {
        color = kLight;
      } else if (place < 2 * line && color == kClear) {
        color = kDark;
      }
    };
    constexpr int kTall = 1 << 20;  // keeps the difference positive
    if (marks & kNotSkin) draw((x + y) % lines);
    if (marks & kAtBound) draw((x + kTall * lines - y) % lines);
    if (marks & kMostlyPrior) draw(std::max(x % dots, y % dots));
    return color;
  }
};

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

QString markText(PixelMark mark) {
  switch (mark) {
    case kNotSkin:
      return QCoreApplication::translate("Hatching", "Not like skin");
    case kAtBound:
      return QCoreApplication::translate("Hatching", "At the end of its range");
    case kMostlyPrior:
      return QCoreApplication::translate("Hatching", "Assumed rather than measured");
  }
  return {};
}

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

void drawHatchSample(QPainter& painter, const QRectF& area, PixelMark mark) {
  const double ratio = painter.device()->devicePixelRatioF();
  const QSize size = (area.size() * ratio).toSize();
  QImage sample(size, QImage::Format_ARGB32_Premultiplied);
  const HatchPattern pattern(ratio);
  for (int y = 0; y < size.height(); ++y) {
    for (int x = 0; x < size.width(); ++x)
      sample.setPixel(x, y, pattern.at(mark, x, y));
  }
  sample.setDevicePixelRatio(ratio);
  painter.drawImage(area.topLeft(), sample);
}

}  // namespace cutis
