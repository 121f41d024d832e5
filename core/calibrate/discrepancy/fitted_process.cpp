#include "core/calibrate/discrepancy/fitted_process.h"

#include <algorithm>
#include <cstddef>

#include "core/calibrate/discrepancy/discrepancy_reduction.h"
#include "core/maths/decompositions.h"
#include "core/maths/quantile.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// How many people the smooth process and the prior at hand count for.
constexpr double kSmoothPeople = 5.0;
constexpr double kPriorPeople = 8.0;
// How many people's worth of no slope at all the regression is drawn towards.
constexpr double kRidgePeople = 10.0;
// Whoever is left over this many times as much as the median person counts for less.
constexpr double kOdd = 3.0;

}  // namespace

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

DiscrepancyProcess processOf(const std::vector<WholeFit>& fits, const std::vector<double>& weights,
                             const std::vector<Index>& at, const DiscrepancyProcess& smooth) {
  const MatrixXd expected = smooth.covariance(at, at);
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

VectorXd leftOutVariance(const std::vector<WholeFit>& fits, const std::vector<double>& weights,
                         const std::vector<Index>& at, const DiscrepancyProcess& smooth,
                         const VectorXd& reflectance, int components) {
  const VectorXd typical = reflectance(at);
  const std::vector<Index> seen = seenOf(at);
  VectorXd squares = VectorXd::Zero(typical.size());
  double people = 0.0;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (weights[i] == 0.0) continue;
    std::vector<double> others = weights;
    others[i] = 0.0;
    const DiscrepancyProcess process = processOf(fits, others, at, smooth);
    const SeenComponents told =
        seenComponents(process.totalCovariance(), typical, seen, components);
    const VectorXd away = fits[i].leftOver - process.mean;
    const VectorXd missed = away - told.spectra * (told.coefficients * away(seen));
    squares += weights[i] * missed.cwiseAbs2();
    people += weights[i];
  }
  return squares / people;
}

}  // namespace cutis
