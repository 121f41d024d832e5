#include "ui/color/display_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/analyse/skin_values.h"

namespace cutis {
namespace {

// A logarithm needs an end above 0: three decades show all that can be told apart.
constexpr double kDecadesShare = 1e-3;
constexpr double kMarginShare = 0.15;

DisplayRange logarithmic(DisplayRange range) {
  range.minimum = std::max(range.minimum, kDecadesShare * range.maximum);
  range.isLogarithmic = true;
  return range;
}

}  // namespace

PositionIn::PositionIn(const DisplayRange& range)
    : isLogarithmic_(range.isLogarithmic),
      offset_(isLogarithmic_ ? std::log(range.minimum) : range.minimum),
      factor_(1.0 / ((isLogarithmic_ ? std::log(range.maximum) : range.maximum) - offset_)) {}

double PositionIn::operator()(double value) const {
  if (!isLogarithmic_) return (value - offset_) * factor_;
  if (value <= 0.0) return -std::numeric_limits<double>::infinity();
  return (std::log(value) - offset_) * factor_;
}

double valueAt(const DisplayRange& range, double position) {
  if (!range.isLogarithmic) return range.minimum + position * (range.maximum - range.minimum);
  return range.minimum * std::pow(range.maximum / range.minimum, position);
}

DisplayRange rangeOfValues(const std::vector<float>& sorted, bool isLogarithmic) {
  const auto typical = typicalRange(sorted);
  DisplayRange range;
  if (typical) range = {typical->minimum, typical->maximum};
  return isLogarithmic ? logarithmic(range) : range;
}

DisplayRange axisAround(const DisplayRange& range, const std::vector<float>& sorted) {
  const DisplayRange usual = rangeOfValues(sorted, range.isLogarithmic);
  DisplayRange axis = range;
  axis.minimum = std::min(range.minimum, valueAt(usual, -kMarginShare));
  axis.maximum = std::max(range.maximum, valueAt(usual, 1.0 + kMarginShare));
  if (!axis.isLogarithmic) axis.minimum = std::max(axis.minimum, std::min(0.0, range.minimum));
  return axis;
}

std::vector<float> heightsAlong(const DisplayRange& axis, const std::vector<float>& sorted,
                                int count) {
  std::vector<float> heights;
  auto from = std::lower_bound(sorted.begin(), sorted.end(), valueAt(axis, 0.0));
  for (int i = 1; i <= count; ++i) {
    const auto to = std::lower_bound(from, sorted.end(), valueAt(axis, double{1} * i / count));
    heights.push_back(static_cast<float>(to - from));
    from = to;
  }
  const float most = *std::max_element(heights.begin(), heights.end());
  if (most == 0.0f) return {};
  for (float& height : heights)
    height /= most;
  return heights;
}

}  // namespace cutis
