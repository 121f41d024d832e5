#pragma once

// A prior as what it is: a normal distribution of the coordinates of the parameters.

#include <Eigen/Core>

#include "core/skin/profile/prior.h"

namespace cutis {

using Coordinates = Eigen::Matrix<double, kParameterCount, 1>;

struct CoordinateDistribution {
  Coordinates mean = Coordinates::Zero();
  ParameterMatrix covariance = ParameterMatrix::Identity();
};

// Logarithms where the prior has them, else the parameters. Positive where they are logarithms.
Coordinates coordinatesOf(const Prior& prior, const ParameterVector& parameters);
ParameterVector parametersOf(const Prior& prior, const Coordinates& coordinates);

CoordinateDistribution coordinateDistribution(const Prior& prior);
// With the scale of `like`, and with what stays linear there.
Prior priorFrom(const CoordinateDistribution& distribution, const Prior& like);

}  // namespace cutis
