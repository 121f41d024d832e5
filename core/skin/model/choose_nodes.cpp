#include "core/skin/model/choose_nodes.h"

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "core/skin/model/compiled_model.h"
#include "core/skin/model/reflectance_batch.h"
#include "core/skin/profile/parameter_sampling.h"

namespace cutis {
namespace {

constexpr int kTrainingCount = 2000;
constexpr int kCheckingCount = 1000;

SpectrumRows sampledSpectra(const CompiledModel& grid, const ParameterAxes& axes, int count,
                            int first) {
  const std::vector<ParameterVector> points = sampleBox(axes, count, first);
  const PixelBuffer<double> parameters = parameterRows<double>(points);
  Eigen::Array<double, Eigen::Dynamic, kSampleCount> spectra(count, int{kSampleCount});
  reflectanceBatch<double>(grid, parameters.rows(),
                           packedRows(spectra.data(), kSampleCount, points.size()));
  return spectra;
}

SpectralNodes choose(const SkinModel& model, const SpectrumRows& rows, const NodeOptions& options) {
  std::vector<int> all(kSampleCount);
  std::iota(all.begin(), all.end(), 0);
  const CompiledModel grid(model, std::move(all));
  const ParameterAxes& axes = model.profile().axes;
  return chooseSpectralNodes(rows, sampledSpectra(grid, axes, kTrainingCount, 0),
                             sampledSpectra(grid, axes, kCheckingCount, kTrainingCount), options);
}

}  // namespace

SpectralNodes chooseNodes(const SkinModel& model, const SpectrumRows& rows,
                          const NodeOptions& options) {
  return model.nodeCache().get(rows, options, [&] { return choose(model, rows, options); });
}

}  // namespace cutis
