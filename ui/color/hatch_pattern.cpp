#include "ui/color/hatch_pattern.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QImage>
#include <QPainter>

namespace cutis {
namespace {

constexpr QRgb kLight = 0xffffffff;
constexpr QRgb kDark = 0xff000000;
constexpr QRgb kClear = 0x00000000;
constexpr double kApartLines = 9;  // device-independent pixels, as below
constexpr double kApartDots = 6;
constexpr double kLine = 1;

int inDevicePixels(double length, double ratio, int least) {
  return std::max(least, static_cast<int>(std::lround(length * ratio)));
}

}  // namespace

HatchPattern::HatchPattern(double ratio)
    : lines(inDevicePixels(kApartLines, ratio, 4)),
      dots(inDevicePixels(kApartDots, ratio, 4)),
      line(inDevicePixels(kLine, ratio, 1)) {}

QRgb HatchPattern::at(PixelMarks marks, int x, int y) const {
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
