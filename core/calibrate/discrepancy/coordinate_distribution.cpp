#include "core/calibrate/discrepancy/coordinate_distribution.h"

#include <cmath>

namespace cutis {

Coordinates coordinatesOf(const Prior& prior, const ParameterVector& parameters) {
  Coordinates coordinates;
  for (int k = 0; k < kParameterCount; ++k) {
    coordinates[k] = prior.isLog(k) ? std::log(parameters[k]) : parameters[k];
  }
  return coordinates;
}

ParameterVector parametersOf(const Prior& prior, const Coordinates& coordinates) {
  ParameterVector parameters;
  for (int k = 0; k < kParameterCount; ++k) {
    parameters[k] = prior.isLog(k) ? std::exp(coordinates[k]) : coordinates[k];
  }
  return parameters;
}

CoordinateDistribution coordinateDistribution(const Prior& prior) {
  const auto deviations = prior.deviation.matrix().asDiagonal();
  return {coordinatesOf(prior, prior.mean), deviations * prior.correlation * deviations};
}

Prior priorFrom(const CoordinateDistribution& distribution, const Prior& like) {
  Prior prior = like;
  prior.mean = parametersOf(like, distribution.mean);
  for (int k = 0; k < kParameterCount; ++k) {
    prior.deviation[k] = std::sqrt(distribution.covariance(k, k));
    prior.correlation(k, k) = 1.0;
  }
  for (int i = 0; i < kParameterCount; ++i) {
    for (int j = 0; j < i; ++j) {
      const double correlation =
          distribution.covariance(i, j) / (prior.deviation[i] * prior.deviation[j]);
      prior.correlation(i, j) = correlation;
      prior.correlation(j, i) = correlation;
    }
  }
  return prior;
}

}  // namespace cutis
