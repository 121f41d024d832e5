#include "core/analyse/skin_values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "core/analyse/gamut.h"

namespace cutis {
namespace {

constexpr double kFewestShare = 0.01;
constexpr double kSmallestRange = 1e-4;
constexpr double kTypicalShare = 0.01;  // that lies beyond either end
// Half floats and steps within limits end a little below.
constexpr double kEndShare = 0.999;

// What runs to its end where a pixel is darker, redder or paler than skin. The blend and carotene
// reach theirs in skin as well.
constexpr Parameter kConcentrations[] = {kMelanin, kHaemoglobinDermal, kHaemoglobinEpidermal};

bool isWithin(const JudgedPixels& pixels, std::size_t i, const ParameterAxes& axes) {
  return std::all_of(std::begin(kConcentrations), std::end(kConcentrations), [&](Parameter k) {
    const auto row = static_cast<std::size_t>(k);
    return double{pixels.values[row][i]} < kEndShare * axes[row].maximum;
  });
}

SkinValues valuesOf(const JudgedPixels& pixels, const std::vector<std::uint8_t>& chosen) {
  SkinValues values;
  for (std::size_t k = 0; k < values.sorted.size(); ++k) {
    for (std::size_t i = 0; i < pixels.count(); ++i) {
      if (chosen[i]) values.sorted[k].push_back(pixels.values[k][i]);
    }
    std::sort(values.sorted[k].begin(), values.sorted[k].end());
  }
  return values;
}

}  // namespace

SkinValues skinValuesOf(const JudgedPixels& pixels, const ParameterAxes& axes) {
  std::vector<std::uint8_t> isSkin = pixels.isSkin;
  for (std::size_t i = 0; i < pixels.count(); ++i)
    isSkin[i] = isSkin[i] && isWithin(pixels, i, axes) ? 1 : 0;
  const auto count = std::count(isSkin.begin(), isSkin.end(), 1);
  if (static_cast<double>(count) < kFewestShare * static_cast<double>(pixels.count()))
    isSkin.assign(pixels.count(), 1);
  SkinValues values = valuesOf(pixels, isSkin);
  values.medianDeltaE = gamutOf(pixels).medianDeltaE;
  return values;
}

std::optional<ValueRange> typicalRange(const std::vector<float>& sorted) {
  if (sorted.empty()) return std::nullopt;
  const auto at = [&](double share) {
    const double last = static_cast<double>(sorted.size() - 1);
    return double{sorted[static_cast<std::size_t>(std::lround(share * last))]};
  };
  const ValueRange range = {at(kTypicalShare), at(1.0 - kTypicalShare)};
  if (range.minimum < range.maximum) return range;
  return ValueRange{0.0, std::max(range.maximum, kSmallestRange)};
}

}  // namespace cutis
