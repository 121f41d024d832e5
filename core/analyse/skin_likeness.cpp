#include "core/analyse/skin_likeness.h"

#include <cmath>
#include <utility>

#include "core/analyse/pixel_sample.h"

namespace cutis {
namespace {

constexpr std::size_t kLookedAt = 65536;
constexpr double kMostDeviations = 3.0;

void judgeByColor(const Rig& rig, const PixelSolver& solver, const PixelSample& sample,
                  JudgedPixels& judged) {
  judged.deltaE = reconstructionDeltaE(rig, solver, sample);
  for (const double difference : judged.deltaE)
    judged.isSkin.push_back(difference <= kSameColorDeltaE ? 1 : 0);
}

void judgeByNoise(const NoiseModel& noise, const PixelSolver& solver, const PixelSample& sample,
                  JudgedPixels& judged) {
  const std::size_t channelCount = sample.channels.rowCount();
  PixelBuffer<float> residuals(channelCount, sample.count);
  solver.residuals(sample.channels.rows(), sample.values.rows(), residuals.rows());
  for (std::size_t i = 0; i < sample.count; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < channelCount; ++k) {
      const double deviation = std::sqrt(noise.variance(double{sample.channels[k][i]}));
      // A black channel under purely proportional noise says nothing.
      if (deviation > 0.0) sum += std::pow(double{residuals[k][i]} / deviation, 2);
    }
    const bool isSkin = std::sqrt(sum / static_cast<double>(channelCount)) <= kMostDeviations;
    judged.isSkin.push_back(isSkin ? 1 : 0);
  }
}

NoiseModel assumedNoise(const std::optional<NoiseModel>& noise, const Rig& rig) {
  const NoiseModel assumed = noise.value_or(rig.noise);
  if (!assumed.isExact()) return assumed;
  return rig.noise.isExact() ? NoiseModel{} : rig.noise;
}

}  // namespace

Result<JudgedPixels> judgePixels(const Measurements& measurements, const ChromophoreMaps& maps,
                                 const PixelSolver& solver, const std::optional<NoiseModel>& noise,
                                 const JobContext& context) {
  CUTIS_TRY(sample, samplePixels(measurements, &maps, kLookedAt, context));
  const Rig& rig = measurements.rig;
  JudgedPixels judged;
  if (sample.count > 0 && seesColors(rig)) {
    judgeByColor(rig, solver, sample, judged);
  } else if (sample.count > 0) {
    judgeByNoise(assumedNoise(noise, rig), solver, sample, judged);
  }
  judged.values = std::move(sample.values);
  return judged;
}

Result<JudgedPixels> judgePixels(const ChromophoreMaps& maps, const JobContext& context) {
  CUTIS_TRY(sample, sampleMaps(maps, kLookedAt, context));
  JudgedPixels judged;
  judged.isSkin.assign(sample.count, 1);
  judged.values = std::move(sample.values);
  return judged;
}

}  // namespace cutis
