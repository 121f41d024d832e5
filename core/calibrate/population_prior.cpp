#include "core/calibrate/population_prior.h"

#include <vector>

#include "core/base/parallel.h"
#include "core/calibrate/discrepancy/coordinate_distribution.h"
#include "core/calibrate/fitted_range.h"
#include "core/fit/reference/map_estimator.h"

namespace cutis {
namespace {

using Eigen::Index;

constexpr int kRounds = 20;
CoordinateDistribution populationOf(const Prior& prior, const std::vector<Estimate>& people) {
  const auto count = static_cast<double>(people.size());
  CoordinateDistribution result = {Coordinates::Zero(), ParameterMatrix::Zero()};
  for (const Estimate& person : people) {
    result.mean += coordinatesOf(prior, person.parameters) / count;
  }
  for (const Estimate& person : people) {
    const Coordinates away = coordinatesOf(prior, person.parameters) - result.mean;
    result.covariance += (away * away.transpose() + person.covariance) / count;
  }
  return result;
}

}  // namespace

Result<Prior> populationPrior(const SkinModel& model, const MeasurementGeometry& geometry,
                              const SpectraSet& spectra, double noise, const Prior& start,
                              const JobContext& context) {
  const std::vector<Index> rows = fittedRows(spectra);
  Prior prior = start;
  std::vector<Estimate> people(static_cast<std::size_t>(spectra.count()));
  for (int round = 0; round < kRounds; ++round) {
    EstimatorOptions options;
    options.prior = prior;
    options.noise = {noise, 0.0};
    options.geometry = geometry;
    const MapEstimator estimator(model, fittedNodes(spectra), options);
    const double done = static_cast<double>(round) / kRounds;
    CUTIS_CHECK(parallelFor(
        people.size(), context.child(done, done + 1.0 / kRounds), [&](std::size_t i) -> Status {
          const Eigen::VectorXd channels =
              spectra.measured.matrix().col(static_cast<Index>(i))(rows);
          const ParameterVector from = round == 0 ? start.mean : people[i].parameters;
          people[i] = estimator.solve(channels, from);
          return {};
        }));
    prior = priorFrom(populationOf(prior, people), start);
    CUTIS_CHECK(validate(prior, "the prior of the spectra"));
  }
  return prior;
}

}  // namespace cutis
