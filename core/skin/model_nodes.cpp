#include "core/skin/model_nodes.h"

#include <cstddef>

#include "core/skin/parameter_sampling.h"

namespace cutis {
namespace {

constexpr int kTrainingCount = 2000;
constexpr int kCheckingCount = 1000;

SpectrumRows sampledSpectra(const SkinModel& model, int count, int first) {
  const std::vector<ParameterVector> points = sampleBox(model.profile().axes, count, first);
  SpectrumRows spectra(count, kSampleCount);
  for (int i = 0; i < count; ++i) {
    spectra.row(i) = model.reflectance(points[static_cast<std::size_t>(i)]).transpose();
  }
  return spectra;
}

}  // namespace

SpectralNodes chooseModelNodes(const SkinModel& model, const SpectrumRows& rows,
                               const NodeOptions& options) {
  return chooseSpectralNodes(rows, sampledSpectra(model, kTrainingCount, 0),
                             sampledSpectra(model, kCheckingCount, kTrainingCount), options);
}

}  // namespace cutis
