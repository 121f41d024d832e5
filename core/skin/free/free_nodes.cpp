#include "core/skin/free/free_nodes.h"

#include <cstddef>
#include <vector>

#include "core/base/parallel.h"
#include "core/skin/free/free_skin.h"
#include "core/skin/profile/parameter_sampling.h"

namespace cutis {
namespace {

constexpr int kFreeTrainingCount = 3000;
constexpr int kFreeCheckingCount = 1000;
constexpr std::size_t kBatch = 50;
// Between thicknesses of the tables the spectra here are mixtures of those at the tables', so that
// nodes for the ones hold for the others, and a few thicknesses suffice.
constexpr int kThicknesses = 6;
// Shares of the progress: the tables of the layers, and the spectra.
constexpr double kTablesEnd = 0.8, kSpectraEnd = 0.9;

std::vector<int> seenSamples(const SpectrumRows& rows) {
  std::vector<int> samples;
  for (int s = 0; s < kSampleCount; ++s) {
    if ((rows.col(s) != 0.0).any()) samples.push_back(s);
  }
  return samples;
}

// Zero at samples that the skin is not evaluated at.
Result<SpectrumRows> sampledFreeSpectra(const FreeSkin& skin, int count, int first,
                                        const JobContext& context) {
  const std::vector<ParameterVector> people = sampleBox(skin.axes(), count, first);
  std::vector<SkinConstants> constants;
  for (int i = 0; i < count; ++i) {
    double coordinates[kConstantCount];
    for (int k = 0; k < kConstantCount; ++k)
      coordinates[k] = samplePlace(k, first + i);
    constants.push_back(skin.coordinates().constantsAt(coordinates));
  }
  SpectrumRows spectra = SpectrumRows::Zero(count, kSampleCount);
  const std::size_t pieces = people.size() / kBatch;
  CUTIS_CHECK(parallelFor(pieces, context, [&](std::size_t piece) -> Status {
    const std::size_t begin = piece * kBatch;
    const auto of = [&](const auto& all) { return std::span(all).subspan(begin, kBatch); };
    const FreeSpectra part = skin.evaluate(of(people), of(constants), false);
    for (std::size_t s = 0; s < skin.samples().size(); ++s) {
      for (std::size_t i = 0; i < kBatch; ++i) {
        spectra(static_cast<Eigen::Index>(begin + i), skin.samples()[s]) =
            part.reflectance[s * kBatch + i];
      }
    }
    return {};
  }));
  return spectra;
}

static_assert(kFreeTrainingCount % kBatch == 0 && kFreeCheckingCount % kBatch == 0);

}  // namespace

Result<SpectralNodes> chooseFreeNodes(const SkinModel& model, const SpectrumRows& rows,
                                      const FreeConstants& free, const NodeOptions& options,
                                      const JobContext& context) {
  CUTIS_TRY(skin, FreeSkin::make(model, seenSamples(rows), free, context.child(0.0, kTablesEnd),
                                 {0.0, kThicknesses}));
  CUTIS_TRY(training, sampledFreeSpectra(skin, kFreeTrainingCount, 0,
                                         context.child(kTablesEnd, kSpectraEnd)));
  CUTIS_TRY(checking, sampledFreeSpectra(skin, kFreeCheckingCount, kFreeTrainingCount,
                                         context.child(kSpectraEnd, kSpectraEnd)));
  return chooseSpectralNodes(rows, training, checking, options);
}

}  // namespace cutis
