#include "src/report/plot/ticks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <iterator>

namespace cutis {
namespace {

// Rounding noise of multiples such as 3 · 0.1.
constexpr double kTickSlack = 1e-9;

double powerOfTen(double exponent) {
  return std::pow(10.0, exponent);
}

}  // namespace

double niceStep(double span, int most) {
  if (!(span > 0.0) || !std::isfinite(span)) return 1.0;
  const double least = span / std::max(most, 1) * (1.0 - kTickSlack);
  const double power = powerOfTen(std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

double niceCeiling(double value, int most) {
  const double step = niceStep(value, most);
  return step * std::ceil(value / step - kTickSlack);
}

std::vector<double> ticksWithin(double minimum, double maximum, double step) {
  std::vector<double> ticks;
  const double last = std::floor(maximum / step + kTickSlack);
  for (double i = std::ceil(minimum / step - kTickSlack); i <= last; ++i)
    ticks.push_back(i * step);
  return ticks;
}

std::vector<double> logarithmicTicks(double minimum, double maximum, int most) {
  if (!(minimum > 0.0) || !(maximum >= minimum) || !std::isfinite(maximum)) return {};
  const auto ticksOf = [&](std::initializer_list<double> factors) {
    std::vector<double> ticks;
    const double last = std::ceil(std::log10(maximum));
    for (double exponent = std::floor(std::log10(minimum)); exponent <= last; ++exponent) {
      for (const double factor : factors) {
        const double tick = factor * powerOfTen(exponent);
        if (tick >= minimum * (1.0 - kTickSlack) && tick <= maximum * (1.0 + kTickSlack))
          ticks.push_back(tick);
      }
    }
    return ticks;
  };
  auto fine = ticksOf({1.0, 2.0, 5.0});
  return fine.size() <= static_cast<std::size_t>(std::max(most, 0)) ? fine : ticksOf({1.0});
}

std::pair<double, double> roundEnds(double minimum, double maximum) {
  constexpr int all = 10000;
  const auto ticks = logarithmicTicks(minimum / 20.0, maximum * 20.0, all);
  const auto above = std::upper_bound(ticks.begin(), ticks.end(), minimum * (1.0 + kTickSlack));
  const auto end = std::lower_bound(above, ticks.end(), maximum * (1.0 - kTickSlack));
  return {*std::prev(above), *end};
}

std::pair<double, double> decadeEnds(double minimum, double maximum) {
  const double first = std::floor(std::log10(minimum) + kTickSlack);
  const double last = std::ceil(std::log10(maximum) - kTickSlack);
  return {powerOfTen(first), powerOfTen(std::max(last, first + 1.0))};
}

int decimalsFor(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - kTickSlack)), 0, 9);
}

std::string tickWords(double value, double step) {
  const int decimals = decimalsFor(step);
  // No "−0.00".
  const bool isZero = std::abs(value) < 0.5 * powerOfTen(-decimals);
  std::array<char, 64> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), isZero ? 0.0 : std::abs(value),
                    std::chars_format::fixed, decimals);
  // What has more digits than that is nothing to read on an axis.
  if (end.ec != std::errc()) return {};
  return (value < 0.0 && !isZero ? "−" : "") + std::string(buffer.data(), end.ptr);
}

}  // namespace cutis
