#include "core/analyse/skin_values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/analyse/pixel_sample.h"
#include "core/analyse/skin_likeness.h"

namespace cutis {
namespace {

constexpr std::size_t kLookedAt = 65536;
constexpr double kFewestShare = 0.01;
constexpr double kTypicalShare = 0.01;  // that lies beyond either end
// Half floats and steps within limits end a little below.
constexpr double kEndShare = 0.999;

// What runs to its end where a pixel is darker, redder or paler than skin. The blend and carotene
// reach theirs in skin as well.
constexpr Parameter kConcentrations[] = {kMelanin, kHaemoglobinDermal, kHaemoglobinEpidermal};

bool isWithin(const PixelSample& sample, std::size_t i, const ParameterAxes& axes) {
  return std::all_of(std::begin(kConcentrations), std::end(kConcentrations), [&](Parameter k) {
    const auto row = static_cast<std::size_t>(k);
    return double{sample.values[row][i]} < kEndShare * axes[row].maximum;
  });
}

SkinValues valuesOf(const PixelSample& sample, const std::vector<std::uint8_t>& chosen) {
  SkinValues values;
  for (std::size_t k = 0; k < values.sorted.size(); ++k) {
    for (std::size_t i = 0; i < sample.count; ++i) {
      if (chosen[i]) values.sorted[k].push_back(sample.values[k][i]);
    }
    std::sort(values.sorted[k].begin(), values.sorted[k].end());
  }
  return values;
}

SkinValues skinOf(const PixelSample& sample, const ParameterAxes& axes,
                  std::vector<std::uint8_t> isSkin) {
  for (std::size_t i = 0; i < sample.count; ++i)
    isSkin[i] = isSkin[i] && isWithin(sample, i, axes) ? 1 : 0;
  const auto count = std::count(isSkin.begin(), isSkin.end(), 1);
  if (static_cast<double>(count) < kFewestShare * static_cast<double>(sample.count))
    isSkin.assign(sample.count, 1);
  return valuesOf(sample, isSkin);
}

}  // namespace

Result<SkinValues> skinValuesOf(const Measurements& measurements, const ChromophoreMaps& maps,
                                const PixelSolver& solver, const std::optional<NoiseModel>& noise,
                                const ParameterAxes& axes, const JobContext& context) {
  CUTIS_TRY(sample, samplePixels(measurements, &maps, kLookedAt, context));
  if (sample.count == 0) return SkinValues{};
  return skinOf(sample, axes, judgeSkin(measurements.rig, solver, noise, sample).isSkin);
}

Result<SkinValues> skinValuesOf(const ChromophoreMaps& maps, const ParameterAxes& axes,
                                const JobContext& context) {
  CUTIS_TRY(sample, sampleMaps(maps, kLookedAt, context));
  return skinOf(sample, axes, std::vector<std::uint8_t>(sample.count, 1));
}

std::optional<ValueRange> typicalRange(const std::vector<float>& sorted) {
  if (sorted.empty()) return std::nullopt;
  const auto at = [&](double share) {
    const double last = static_cast<double>(sorted.size() - 1);
    return double{sorted[static_cast<std::size_t>(std::lround(share * last))]};
  };
  const ValueRange range = {at(kTypicalShare), at(1.0 - kTypicalShare)};
  if (!(range.minimum < range.maximum)) return std::nullopt;
  return range;
}

}  // namespace cutis
