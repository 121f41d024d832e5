#include "core/calibrate/discrepancy_learning.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/calibrate/discrepancy/discrepancy_process.h"
#include "core/calibrate/discrepancy/discrepancy_reduction.h"
#include "core/calibrate/discrepancy/fitted_process.h"
#include "core/calibrate/discrepancy/whole_spectrum_fit.h"
#include "core/skin/model/instrument_model.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr char kSpectraPlace[] = "the spectra";
// Fits with the smooth process, and again with what was learned then.
constexpr int kLearningRounds = 2;

Status checkSpectra(const SpectraSet& spectra, int components) {
  const Index fewest = std::max<Index>(kFewestPeople, components + 1);
  if (spectra.count() < fewest) {
    return inputError(kSpectraPlace,
                      "too few people to learn from: " + std::to_string(spectra.count()) +
                          " where at least " + std::to_string(fewest) + " are needed");
  }
  const bool reaches = !spectra.samples.empty() &&
                       wavelengthNm(spectra.samples.front()) <= kFittedFromNm &&
                       wavelengthNm(spectra.samples.back()) >= kFittedToNm;
  if (!reaches) {
    return inputError(kSpectraPlace,
                      "they must reach at least from 400 to 700 nm to learn from them");
  }
  for (Index spectrum = 0; spectrum < spectra.count(); ++spectrum) {
    for (Index row = 0; row < spectra.measured.rows(); ++row) {
      if (spectra.measured(row, spectrum) > 0.0) continue;
      return inputError(kSpectraPlace, "spectrum " + std::to_string(spectrum + 1) +
                                           " has a reflectance that is not positive at " +
                                           std::to_string(static_cast<int>(wavelengthNm(
                                               spectra.samples[static_cast<std::size_t>(row)]))) +
                                           " nm; leave that wavelength or that spectrum out");
    }
  }
  return {};
}

// Linear between the samples measured.
WorkingSpectra workingSpectra(const SpectraSet& spectra) {
  WorkingSpectra result;
  const std::vector<int>& samples = spectra.samples;
  for (Index i = 0; i < kWorkingCount; ++i) {
    const int sample = gridSample(i);
    if (sample >= samples.front() && sample <= samples.back()) result.at.push_back(i);
  }
  result.measured.resize(static_cast<Index>(result.at.size()), spectra.count());
  std::size_t above = 1;
  for (Index i = 0; i < result.measured.rows(); ++i) {
    const int sample = gridSample(result.at[static_cast<std::size_t>(i)]);
    while (samples[above] < sample)
      ++above;
    const int from = samples[above - 1], to = samples[above];
    const double share = static_cast<double>(sample - from) / (to - from);
    const auto row = static_cast<Index>(above);
    result.measured.row(i) =
        ((1.0 - share) * spectra.measured.row(row - 1) + share * spectra.measured.row(row))
            .matrix();
  }
  return result;
}

}  // namespace

Result<Discrepancy> learnDiscrepancy(const SkinModel& model, const SpectraSet& spectra,
                                     const DiscrepancyLearning& options,
                                     const JobContext& context) {
  CUTIS_CHECK(checkSpectra(spectra, options.components));
  const WorkingSpectra working = workingSpectra(spectra);
  const InstrumentModel instrument(model, {0.0, 1.0, options.edgeLossPerMm});
  const DiscrepancyProcess smooth = smoothProcess(coordinateDistribution(options.prior));
  DiscrepancyProcess process = smooth;
  std::vector<WholeFit> fits;
  std::vector<double> weights;
  for (int round = 0; round < kLearningRounds; ++round) {
    const double done = static_cast<double>(round) / kLearningRounds;
    CUTIS_TRY(fitted, fitWholeSpectra(instrument, model.profile().axes, options.prior, process,
                                      working, context.child(done, done + 1.0 / kLearningRounds)));
    fits = std::move(fitted);
    const auto converged =
        std::count_if(fits.begin(), fits.end(), [](const WholeFit& fit) { return fit.converged; });
    if (converged < kFewestPeople) {
      return inputError(kSpectraPlace, "the model follows only " + std::to_string(converged) +
                                           " of them, too few to learn from");
    }
    weights = weightsOf(fits, smooth.covariance.diagonal()(working.at).cwiseSqrt());
    process = extended(processOf(fits, weights, working.at, smooth), working.at);
  }
  const VectorXd typical = typicalReflectance(process, model, options.prior);
  VectorXd leftOut = VectorXd::Zero(kWorkingCount);
  leftOut(working.at) =
      leftOutVariance(fits, weights, working.at, smooth, typical, options.components);
  Discrepancy discrepancy = reduced(process, typical, leftOut, options.components, options.prior);
  CUTIS_CHECK(validate(discrepancy, "the discrepancy of the spectra", ""));
  return discrepancy;
}

}  // namespace cutis
