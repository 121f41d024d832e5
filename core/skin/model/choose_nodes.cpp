#include "core/skin/model/choose_nodes.h"

#include <array>
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
  std::array<std::vector<double>, kParameterCount> columns;
  ParameterBatch<double> batch;
  batch.count = points.size();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    for (const ParameterVector& point : points)
      columns[k].push_back(point[static_cast<int>(k)]);
    batch.values[k] = columns[k].data();
  }
  Eigen::Array<double, Eigen::Dynamic, kSampleCount> spectra(count, int{kSampleCount});
  reflectanceBatch<double>(grid, batch, spectra.data());
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
