#include "src/report/plot/axis.h"

#include <cmath>
#include <limits>
#include <tuple>

namespace cutis {
namespace {

bool isPowerOfTen(double value) {
  const double exponent = std::log10(value);
  return std::abs(exponent - std::round(exponent)) < 1e-6;
}

}  // namespace

Axis linearAxis(double from, double to, int steps, const TickWords& words) {
  Axis axis;
  axis.from = from;
  axis.to = to;
  if (!std::isfinite(from) || !std::isfinite(to)) return axis;
  const double step = niceStep(to - from, steps);
  for (const double value : ticksWithin(from, to, step))
    axis.ticks.push_back({value, words(value, step), {}, false});
  return axis;
}

Axis logarithmicAxis(double from, double to, const TickWords& words) {
  Axis axis;
  axis.from = from;
  axis.to = to;
  axis.logarithmic = true;
  for (const double value : logarithmicTicks(from, to, std::numeric_limits<int>::max()))
    axis.ticks.push_back({value, words(value, value), {}, !isPowerOfTen(value)});
  return axis;
}

Axis decadeAxis(double least, double most) {
  Axis axis;
  std::tie(axis.from, axis.to) = decadeEnds(least, most);
  axis.logarithmic = true;
  for (const double value : logarithmicTicks(axis.from, axis.to, 0)) {
    const long exponent = std::lround(std::log10(value));
    const std::string digits = std::to_string(std::abs(exponent));
    axis.ticks.push_back({value, "10", (exponent < 0 ? "−" : "") + digits, false});
  }
  return axis;
}

}  // namespace cutis
