#include "core/analyse/skin_likeness.h"

#include <utility>

#include "core/analyse/misfit.h"

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
  PixelBuffer<float> residuals(sample.channels.rowCount(), sample.count);
  solver.residuals(sample.channels.rows(), sample.values.rows(), residuals.rows());
  for (const double misfit : misfitsOf(noise, sample.channels.rows(), residuals.rows()))
    judged.isSkin.push_back(misfit <= kMostDeviations ? 1 : 0);
}

}  // namespace

JudgedPixels judgePixels(PixelSample sample, const Rig& rig, const PixelSolver& solver,
                         const std::optional<NoiseModel>& noise) {
  JudgedPixels judged;
  if (sample.count > 0 && seesColors(rig)) {
    judgeByColor(rig, solver, sample, judged);
  } else if (sample.count > 0) {
    judgeByNoise(misfitNoise(rig, noise), solver, sample, judged);
  }
  judged.values = std::move(sample.values);
  return judged;
}

Result<JudgedPixels> judgePixels(const Measurements& measurements, const ChromophoreMaps& maps,
                                 const PixelSolver& solver, const std::optional<NoiseModel>& noise,
                                 const JobContext& context) {
  CUTIS_TRY(sample, samplePixels(measurements, &maps, kLookedAt, context));
  return judgePixels(std::move(sample), measurements.rig, solver, noise);
}

Result<JudgedPixels> judgePixels(const ChromophoreMaps& maps, const JobContext& context) {
  CUTIS_TRY(sample, sampleMaps(maps, kLookedAt, context));
  JudgedPixels judged;
  judged.isSkin.assign(sample.count, 1);
  judged.values = std::move(sample.values);
  return judged;
}

}  // namespace cutis
