#include "core/analyse/diffusion_domain.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/analyse/pixel_sample.h"
#include "core/skin/free/free_absorption.h"
#include "core/skin/layers/optics.h"

namespace cutis {
namespace {

constexpr std::size_t kDomainPixels = 16384;
// Pixels whose absorptions are in memory at once.
constexpr std::size_t kDomainBatch = 1024;
constexpr int kStepNm = 10;

std::vector<int> visibleSamples() {
  std::vector<int> samples;
  for (int i = kVisibleBand.first; i <= kVisibleBand.last; i += kStepNm / kWavelengthStepNm)
    samples.push_back(i);
  return samples;
}

// Parameters and oxygenations of the pixels [first, first + count) of a sample.
struct Pixels {
  Pixels(const PixelSample& sample, const FreeConstants& free, const Profile& profile,
         std::size_t first, std::size_t count)
      : parameters(count), oxygenations(count, profile.dermalBlood.oxygenation) {
    const auto value = [&](std::size_t row, std::size_t i) {
      return double{sample.values[row][first + i]};
    };
    for (std::size_t i = 0; i < count; ++i) {
      for (const Parameter parameter : kParameters)
        parameters[i][parameter] = value(static_cast<std::size_t>(parameter), i);
      // The first of the constants that are free.
      if (free.oxygenation) oxygenations[i] = std::clamp(value(kParameterCount, i), 0.0, 1.0);
    }
  }

  std::vector<ParameterVector> parameters;
  std::vector<double> oxygenations;
};

}  // namespace

Result<std::optional<double>> shareOutsideDiffusion(const ChromophoreMaps& maps,
                                                    const Profile& profile,
                                                    const JobContext& context) {
  if (profile.layerOptics != LayerOpticsKind::diffusion) return std::optional<double>();
  CUTIS_TRY(sample, sampleMaps(maps, kDomainPixels, context));
  if (sample.count == 0) return std::optional<double>();
  const auto optics = makeDiffusionOptics(profile);
  const std::vector<int> samples = visibleSamples();
  const FreeAbsorption absorption(profile, samples, maps.free().oxygenation);
  std::size_t outside = 0;
  for (std::size_t first = 0; first < sample.count; first += kDomainBatch) {
    const std::size_t count = std::min(kDomainBatch, sample.count - first);
    const Pixels pixels(sample, maps.free(), profile, first, count);
    const auto layers = absorption.at(pixels.parameters, pixels.oxygenations);
    for (std::size_t i = 0; i < count; ++i) {
      bool holds = true;
      for (std::size_t s = 0; s < samples.size() && holds; ++s) {
        const std::size_t at = s * count + i;
        holds = optics->holds(samples[s], layers.epidermal[at], layers.dermal[at]);
      }
      if (!holds) ++outside;
    }
  }
  return std::optional(static_cast<double>(outside) / static_cast<double>(sample.count));
}

}  // namespace cutis
