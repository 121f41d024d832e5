#include "core/analyse/constants_summary.h"

#include <cstddef>
#include <numeric>
#include <span>

#include "core/analyse/pixel_sample.h"
#include "core/fit/free/free_prior.h"
#include "core/maths/quantile.h"

namespace cutis {
namespace {

constexpr std::size_t kSummarisedPixels = 16384;

// values, deviations: one a pixel, at least one.
ConstantSummary summaryOf(SkinConstant constant, const FreePrior& prior, std::vector<double> values,
                          std::span<const float> deviations) {
  ConstantSummary summary;
  summary.constant = constant;
  std::vector<double> open;
  for (std::size_t i = 0; i < values.size(); ++i)
    open.push_back(double{deviations[i]} / prior.deviation(constant, values[i]));
  summary.mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  summary.low = quantileOf(values, 0.05);
  summary.high = quantileOf(values, 0.95);
  summary.openShare = quantileOf(open, 0.5);
  return summary;
}

}  // namespace

Result<std::vector<ConstantSummary>> summariseConstants(const Measurements& measurements,
                                                        const ChromophoreMaps& maps,
                                                        const PixelSolver& solver,
                                                        const Profile& profile,
                                                        const JobContext& context) {
  std::vector<ConstantSummary> summaries;
  if (solver.free().count() == 0) return summaries;
  CUTIS_TRY(sample, samplePixels(measurements, &maps, kSummarisedPixels, context));
  if (sample.count == 0) return summaries;
  PixelBuffer<float> deviations(sample.values.rowCount(), sample.count);
  solver.deviations(sample.channels.rows(), sample.values.rows(), deviations.rows());
  const FreePrior prior = usualFreePrior(profile);
  std::size_t row = kParameterCount;
  for (const SkinConstant constant : kSkinConstants) {
    if (!solver.free().has(constant)) continue;
    const std::span<const float> values = sample.values[row];
    summaries.push_back(
        summaryOf(constant, prior, {values.begin(), values.end()}, deviations[row]));
    ++row;
  }
  return summaries;
}

}  // namespace cutis
