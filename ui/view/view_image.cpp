#include "ui/view/view_image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/maths/quantile.h"

namespace cutis {
namespace {

constexpr double kShareBelowMaximum = 0.995;

// color(i) gives the colour of sample i where there is an estimate.
template <typename Color>
QImage makeImage(const PictureBuffer& pixels, Color color) {
  QImage image(pixels.width, pixels.height, QImage::Format_RGB32);
  for (int y = 0; y < pixels.height; ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < pixels.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                            static_cast<std::size_t>(x);
      line[x] = pixels.present[i] ? color(i) : maskedPixel(x, y);
    }
  }
  return image;
}

// The next of 1, 1.5, 2, 3, 4, 5, 6, 8, 10 times a power of ten.
double roundUp(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (value <= digit * power) return digit * power;
  }
  return 10.0 * power;
}

}  // namespace

QImage colorImage(const PictureBuffer& picture, const DisplayCurve& curve) {
  const auto& channels = picture.channels;
  if (channels.size() < 3) return {};
  return makeImage(picture, [&](std::size_t i) {
    return qRgb(curve(channels[0][i]), curve(channels[1][i]), curve(channels[2][i]));
  });
}

QImage maskedImage(const ViewPart& part) {
  QImage image(part.pixels.width, part.pixels.height, QImage::Format_RGB32);
  for (int y = 0; y < image.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < image.width(); ++x)
      line[x] = maskedPixel(x, y);
  }
  return image;
}

QImage falseColorImage(const ViewPart& part, ScaleKind scale, const DisplayRange& range) {
  if (part.pixels.channels.empty()) return {};
  const ColorScale& colors = ColorScale::of(scale);
  const auto& values = part.pixels.channels.front();
  const PositionIn position(range);
  return makeImage(part.pixels,
                   [&](std::size_t i) { return colors.at(position(double{values[i]}), 0.0, 1.0); });
}

std::optional<DisplayRange> rangeOf(const ViewPart& part) {
  std::vector<float> values;
  if (!part.pixels.channels.empty()) {
    for (std::size_t i = 0; i < part.pixels.present.size(); ++i) {
      if (part.pixels.present[i]) values.push_back(part.pixels.channels.front()[i]);
    }
  }
  if (values.empty()) return std::nullopt;
  constexpr double kSmallestRange = 1e-4;
  return DisplayRange{
      0.0, roundUp(std::max(double{quantileOf(values, kShareBelowMaximum)}, kSmallestRange))};
}

}  // namespace cutis
