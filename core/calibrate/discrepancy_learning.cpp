#include "core/calibrate/discrepancy_learning.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/calibrate/discrepancy_process.h"
#include "core/calibrate/discrepancy_reduction.h"
#include "core/calibrate/whole_spectrum_fit.h"
#include "core/maths/decompositions.h"
#include "core/maths/quantile.h"
#include "core/skin/model/instrument_model.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr char kSpectraPlace[] = "the spectra";
// Fits with the smooth process, and again with what was learned then.
constexpr int kLearningRounds = 2;
// How many people the smooth process and the prior at hand count for.
constexpr double kSmoothPeople = 5.0;
constexpr double kPriorPeople = 8.0;
// How many people's worth of no slope at all the regression is drawn towards.
constexpr double kRidgePeople = 10.0;
// Whoever is left over this many times as much as the median person counts for less.
constexpr double kOdd = 3.0;

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

// How much each person counts: nothing where the fit came to no end, and the less the further the
// spectrum is from what others leave over.
std::vector<double> weightsOf(const std::vector<WholeFit>& fits, const VectorXd& deviations) {
  VectorXd middle(deviations.size());
  std::vector<double> values;
  for (Index i = 0; i < middle.size(); ++i) {
    values.clear();
    for (const WholeFit& fit : fits) {
      if (fit.converged) values.push_back(fit.leftOver[i]);
    }
    middle[i] = quantileOf(values, 0.5);
  }
  std::vector<double> sizes;
  for (const WholeFit& fit : fits) {
    sizes.push_back((fit.leftOver - middle).cwiseQuotient(deviations).norm());
  }
  values.clear();
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (fits[i].converged) values.push_back(sizes[i]);
  }
  const double most = kOdd * quantileOf(values, 0.5);
  std::vector<double> weights;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const double share = std::min(1.0, most / sizes[i]);
    weights.push_back(fits[i].converged ? share * share : 0.0);
  }
  return weights;
}

// The process of those people. smooth, prior: what it and they are drawn towards.
DiscrepancyProcess processOf(const std::vector<WholeFit>& fits, const std::vector<Index>& at,
                             const DiscrepancyProcess& smooth) {
  const MatrixXd expected = smooth.covariance(at, at);
  const std::vector<double> weights = weightsOf(fits, expected.diagonal().cwiseSqrt());
  const auto samples = static_cast<Index>(at.size());
  double people = 0.0;
  DiscrepancyProcess process;
  process.people = {Coordinates::Zero(), ParameterMatrix::Zero()};
  process.mean = VectorXd::Zero(samples);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (weights[i] == 0.0) continue;
    people += weights[i];
    process.people.mean += weights[i] * fits[i].coordinates;
    process.mean += weights[i] * fits[i].leftOver;
  }
  process.people.mean /= people;
  process.mean /= people;

  ParameterMatrix among = ParameterMatrix::Zero(), unsure = ParameterMatrix::Zero();
  MatrixXd across = MatrixXd::Zero(kParameterCount, samples);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (weights[i] == 0.0) continue;
    const Coordinates away = fits[i].coordinates - process.people.mean;
    among += weights[i] * away * away.transpose();
    unsure += weights[i] * fits[i].covariance;
    across += weights[i] * away * (fits[i].leftOver - process.mean).transpose();
  }
  process.people.covariance =
      (among + unsure + kPriorPeople * smooth.people.covariance) / (people + kPriorPeople);
  process.slope =
      solvePositive(among + kRidgePeople * process.people.covariance, across).transpose();

  process.covariance = kSmoothPeople * expected;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (weights[i] == 0.0) continue;
    const VectorXd left = fits[i].leftOver - process.mean -
                          process.slope * (fits[i].coordinates - process.people.mean);
    process.covariance += weights[i] * left * left.transpose();
  }
  process.covariance /= people + kSmoothPeople;
  return process;
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
  for (int round = 0; round < kLearningRounds; ++round) {
    const double done = static_cast<double>(round) / kLearningRounds;
    CUTIS_TRY(fits, fitWholeSpectra(instrument, model.profile().axes, options.prior, process,
                                    working, context.child(done, done + 1.0 / kLearningRounds)));
    const auto converged =
        std::count_if(fits.begin(), fits.end(), [](const WholeFit& fit) { return fit.converged; });
    if (converged < kFewestPeople) {
      return inputError(kSpectraPlace, "the model follows only " + std::to_string(converged) +
                                           " of them, too few to learn from");
    }
    process = extended(processOf(fits, working.at, smooth), working.at);
  }
  Discrepancy discrepancy = reduced(process, model, options.components, options.prior);
  CUTIS_CHECK(validate(discrepancy, "the discrepancy of the spectra", ""));
  return discrepancy;
}

}  // namespace cutis
