#include "ui/color/range_texts.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <QLocale>

namespace cutis {
namespace {

constexpr double kShare = 0.005;            // of the range
constexpr double kLogarithmicShare = 0.02;  // of the smallest value

}  // namespace

std::array<QString, 3> rangeTexts(const DisplayRange& range) {
  constexpr double slack = 1e-9;
  const double values[] = {range.minimum, valueAt(range, 0.5), range.maximum};
  const double distance =
      range.isLogarithmic ? range.minimum : std::abs(range.maximum - range.minimum);
  const double allowed = (range.isLogarithmic ? kLogarithmicShare : kShare) * distance + slack;
  const auto suffice = [&](int decimals) {
    const double power = std::pow(10.0, decimals);
    return std::all_of(std::begin(values), std::end(values), [&](double value) {
      return std::abs(std::round(value * power) / power - value) <= allowed;
    });
  };
  int decimals = 0;
  while (decimals < 9 && !suffice(decimals))
    ++decimals;
  const auto text = [&](double value) {
    // No "-0.00".
    const bool isTiny = std::abs(value) < 0.5 * std::pow(10.0, -decimals);
    return QLocale().toString(isTiny ? 0.0 : value, 'f', decimals);
  };
  return {text(values[0]), text(values[1]), text(values[2])};
}

}  // namespace cutis
