#include "core/analyse/gamut.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/analyse/pixel_sample.h"
#include "core/analyse/skin_likeness.h"

namespace cutis {
namespace {

constexpr std::size_t kGamutPixels = 65536;

}  // namespace

Result<GamutStatistics> measureGamut(const Measurements& measurements, const ChromophoreMaps& maps,
                                     const PixelSolver& solver,
                                     const std::optional<NoiseModel>& noise,
                                     const JobContext& context) {
  CUTIS_TRY(sample, samplePixels(measurements, &maps, kGamutPixels, context));
  if (sample.count == 0) return GamutStatistics{};
  const SkinLikeness likeness = judgeSkin(measurements.rig, solver, noise, sample);
  const auto outside = std::count(likeness.isSkin.begin(), likeness.isSkin.end(), 0);
  GamutStatistics gamut;
  gamut.outsideShare = static_cast<double>(outside) / static_cast<double>(sample.count);
  std::vector<double> inside;
  for (std::size_t i = 0; i < likeness.deltaE.size(); ++i) {
    if (likeness.isSkin[i]) inside.push_back(likeness.deltaE[i]);
  }
  if (inside.empty()) return gamut;
  const auto middle = inside.begin() + static_cast<std::ptrdiff_t>(inside.size() / 2);
  std::nth_element(inside.begin(), middle, inside.end());
  gamut.medianDeltaE = *middle;
  return gamut;
}

}  // namespace cutis
