#include "ui/plot/axis_ticks.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <QLocale>

namespace cutis {
namespace {

// Rounding noise of multiples such as 3 · 0.1.
constexpr double kSlack = 1e-9;

QString withDecimals(double value, int decimals) {
  const double tiny = 0.5 * std::pow(10.0, -decimals);
  // No "-0.00".
  return QLocale().toString(std::abs(value) < tiny ? 0.0 : value, 'f', decimals);
}

}  // namespace

double niceStep(double span, int most) {
  if (!(span > 0) || !std::isfinite(span)) return 1;
  const double least = span / std::max(most, 1) * (1 - kSlack);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10 * power;
}

double niceCeiling(double value, int most) {
  const double step = niceStep(value, most);
  return step * std::ceil(value / step - kSlack);
}

std::vector<double> ticksWithin(double minimum, double maximum, double step) {
  std::vector<double> ticks;
  const double last = std::floor(maximum / step + kSlack);
  for (double i = std::ceil(minimum / step - kSlack); i <= last; ++i)
    ticks.push_back(i * step);
  return ticks;
}

std::vector<double> logarithmicTicks(double minimum, double maximum, int most) {
  if (!(minimum > 0) || !(maximum >= minimum) || !std::isfinite(maximum)) return {};
  const auto ticksOf = [&](std::initializer_list<double> factors) {
    std::vector<double> ticks;
    const double last = std::ceil(std::log10(maximum));
    for (double power = std::floor(std::log10(minimum)); power <= last; ++power) {
      for (const double factor : factors) {
        const double tick = factor * std::pow(10.0, power);
        if (tick >= minimum * (1 - kSlack) && tick <= maximum * (1 + kSlack)) ticks.push_back(tick);
      }
    }
    return ticks;
  };
  const auto fine = ticksOf({1, 2, 5});
  return fine.size() <= static_cast<std::size_t>(std::max(most, 0)) ? fine : ticksOf({1});
}

QString tickText(double value, double step) {
  const int decimals = static_cast<int>(std::ceil(-std::log10(step) - kSlack));
  return withDecimals(value, std::clamp(decimals, 0, 9));
}

std::array<QString, 3> rangeTexts(double minimum, double maximum) {
  const double values[] = {minimum, (minimum + maximum) / 2, maximum};
  const double allowed = 0.005 * std::abs(maximum - minimum) + kSlack;
  const auto suffice = [&](int decimals) {
    const double power = std::pow(10.0, decimals);
    return std::all_of(std::begin(values), std::end(values), [&](double value) {
      return std::abs(std::round(value * power) / power - value) <= allowed;
    });
  };
  int decimals = 0;
  while (decimals < 9 && !suffice(decimals))
    ++decimals;
  return {withDecimals(values[0], decimals), withDecimals(values[1], decimals),
          withDecimals(values[2], decimals)};
}

}  // namespace cutis
