#include "core/analyse/gamut.h"

#include <algorithm>
#include <cmath>

#include "core/analyse/pixel_sample.h"

namespace cutis {
namespace {

constexpr std::size_t kGamutPixels = 65536;
constexpr double kMostDeviations = 3.0;

GamutStatistics byColor(const Rig& rig, const PixelSolver& solver, const PixelSample& sample) {
  std::vector<double> differences = reconstructionDeltaE(rig, solver, sample);
  const auto inside = std::partition(differences.begin(), differences.end(), [](double difference) {
    return difference <= kSameColorDeltaE;
  });
  GamutStatistics gamut;
  gamut.outsideShare =
      static_cast<double>(differences.end() - inside) / static_cast<double>(sample.count);
  if (inside == differences.begin()) return gamut;
  const auto middle = differences.begin() + (inside - differences.begin()) / 2;
  std::nth_element(differences.begin(), middle, inside);
  gamut.medianDeltaE = *middle;
  return gamut;
}

GamutStatistics byNoise(const NoiseModel& noise, std::size_t channelCount,
                        const PixelSolver& solver, const PixelSample& sample) {
  PixelBuffer<float> residuals(sample.channels.rowCount(), sample.count);
  solver.residuals(sample.channels.rows(), sample.values.rows(), residuals.rows());
  std::size_t outside = 0;
  for (std::size_t i = 0; i < sample.count; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < channelCount; ++k) {
      const double deviation = std::sqrt(noise.variance(double{sample.channels[k][i]}));
      // A black channel under purely proportional noise says nothing.
      if (deviation > 0.0) sum += std::pow(double{residuals[k][i]} / deviation, 2);
    }
    if (!(std::sqrt(sum / static_cast<double>(channelCount)) <= kMostDeviations)) ++outside;
  }
  return {static_cast<double>(outside) / static_cast<double>(sample.count), std::nullopt};
}

}  // namespace

Result<GamutStatistics> measureGamut(const Measurements& measurements, const ChromophoreMaps& maps,
                                     const PixelSolver& solver,
                                     const std::optional<NoiseModel>& noise,
                                     const JobContext& context) {
  CUTIS_TRY(sample, samplePixels(measurements, &maps, kGamutPixels, context));
  if (sample.count == 0) return GamutStatistics{};
  const Rig& rig = measurements.rig;
  if (seesColors(rig)) return byColor(rig, solver, sample);
  NoiseModel assumed = noise.value_or(rig.noise);
  if (assumed.isExact()) assumed = rig.noise.isExact() ? NoiseModel{} : rig.noise;
  return byNoise(assumed, measurements.channels.size(), solver, sample);
}

}  // namespace cutis
