#include "ui/color/color_scale.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/color/oklab.h"

namespace cutis {
namespace {

constexpr QRgb kHatchColor = 0xff3d3d3d;

// Catmull-Rom through the points, densely: short straight pieces whose lengths can be summed.
std::vector<OkLab> curveThrough(const std::vector<OkLab>& points) {
  constexpr int kPieces = 256;
  const auto blend = [](double t, double p0, double p1, double p2, double p3) {
    return p1 + 0.5 * t *
                    (p2 - p0 + t * (2 * p0 - 5 * p1 + 4 * p2 - p3 + t * (3 * (p1 - p2) + p3 - p0)));
  };
  std::vector<OkLab> curve = {points.front()};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const OkLab& p0 = points[i == 0 ? 0 : i - 1];
    const OkLab& p1 = points[i];
    const OkLab& p2 = points[i + 1];
    const OkLab& p3 = points[std::min(i + 2, points.size() - 1)];
    for (int k = 1; k <= kPieces; ++k) {
      const double t = static_cast<double>(k) / kPieces;
      curve.push_back({blend(t, p0.lightness, p1.lightness, p2.lightness, p3.lightness),
                       blend(t, p0.a, p1.a, p2.a, p3.a), blend(t, p0.b, p1.b, p2.b, p3.b)});
    }
  }
  return curve;
}

// Equal steps of distance, not of the curve's own parameter: that makes the scale uniform.
std::array<QRgb, 256> sampled(const std::vector<OkLab>& points) {
  const std::vector<OkLab> curve = curveThrough(points);
  std::vector<double> length = {0};
  for (std::size_t i = 1; i < curve.size(); ++i) {
    length.push_back(length.back() + distance(curve[i - 1], curve[i]));
  }
  std::array<QRgb, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double wanted = length.back() * static_cast<double>(i) / 255;
    const auto next = std::lower_bound(length.begin() + 1, length.end() - 1, wanted);
    const auto k = static_cast<std::size_t>(next - length.begin());
    const double t = std::clamp((wanted - length[k - 1]) / (length[k] - length[k - 1]), 0.0, 1.0);
    const OkLab& from = curve[k - 1];
    const OkLab& to = curve[k];
    table[i] = toSrgb({std::lerp(from.lightness, to.lightness, t), std::lerp(from.a, to.a, t),
                       std::lerp(from.b, to.b, t)});
  }
  return table;
}

OkLab fromHue(double lightness, double chroma, double hueDegrees) {
  const double hue = hueDegrees * 3.14159265358979 / 180;
  return {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
}

std::vector<OkLab> pointsOf(ScaleKind kind) {
  switch (kind) {
    case ScaleKind::sequential:
      // Hues from blue over teal to yellow: apart for deuteranopes and protanopes alike, and none
      // of them a colour of skin.
      return {fromHue(0.20, 0.070, 285), fromHue(0.38, 0.105, 262), fromHue(0.54, 0.090, 215),
              fromHue(0.71, 0.120, 165), fromHue(0.86, 0.150, 120), fromHue(0.96, 0.090, 102)};
    case ScaleKind::diverging:
      return {fromHue(0.32, 0.110, 262), fromHue(0.62, 0.110, 245), fromHue(0.95, 0.000, 245),
              fromHue(0.68, 0.110, 65), fromHue(0.36, 0.085, 50)};
    case ScaleKind::grey:
      // The scale does not begin at black: eight bits hold too few steps down there.
      return {{0.12, 0, 0}, {1, 0, 0}};
  }
  return {};
}

}  // namespace

const ColorScale& ColorScale::of(ScaleKind kind) {
  static const ColorScale sequential(sampled(pointsOf(ScaleKind::sequential)));
  static const ColorScale diverging(sampled(pointsOf(ScaleKind::diverging)));
  static const ColorScale grey(sampled(pointsOf(ScaleKind::grey)));
  if (kind == ScaleKind::sequential) return sequential;
  return kind == ScaleKind::diverging ? diverging : grey;
}

QRgb ColorScale::at(double value, double minimum, double maximum) const {
  if (std::isnan(value)) return kMaskedColor;
  const double span = maximum - minimum;
  const double unit = span > 0 ? std::clamp((value - minimum) / span, 0.0, 1.0) : 0.0;
  return table_[static_cast<std::size_t>(std::lround(255 * unit))];
}

QRgb maskedPixel(int x, int y) {
  return ((x + y) & 7) < 2 ? kHatchColor : kMaskedColor;
}

}  // namespace cutis
