#include "core/analyse/skin_likeness.h"

#include <cmath>

namespace cutis {
namespace {

constexpr double kMostDeviations = 3.0;

SkinLikeness byColor(const Rig& rig, const PixelSolver& solver, const PixelSample& sample) {
  SkinLikeness likeness;
  likeness.deltaE = reconstructionDeltaE(rig, solver, sample);
  for (const double difference : likeness.deltaE)
    likeness.isSkin.push_back(difference <= kSameColorDeltaE ? 1 : 0);
  return likeness;
}

SkinLikeness byNoise(const NoiseModel& noise, const PixelSolver& solver,
                     const PixelSample& sample) {
  const std::size_t channelCount = sample.channels.rowCount();
  PixelBuffer<float> residuals(channelCount, sample.count);
  solver.residuals(sample.channels.rows(), sample.values.rows(), residuals.rows());
  SkinLikeness likeness;
  for (std::size_t i = 0; i < sample.count; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < channelCount; ++k) {
      const double deviation = std::sqrt(noise.variance(double{sample.channels[k][i]}));
      // A black channel under purely proportional noise says nothing.
      if (deviation > 0.0) sum += std::pow(double{residuals[k][i]} / deviation, 2);
    }
    const bool isSkin = std::sqrt(sum / static_cast<double>(channelCount)) <= kMostDeviations;
    likeness.isSkin.push_back(isSkin ? 1 : 0);
  }
  return likeness;
}

}  // namespace

SkinLikeness judgeSkin(const Rig& rig, const PixelSolver& solver,
                       const std::optional<NoiseModel>& noise, const PixelSample& sample) {
  if (seesColors(rig)) return byColor(rig, solver, sample);
  NoiseModel assumed = noise.value_or(rig.noise);
  if (assumed.isExact()) assumed = rig.noise.isExact() ? NoiseModel{} : rig.noise;
  return byNoise(assumed, solver, sample);
}

}  // namespace cutis
