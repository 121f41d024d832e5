#pragma once

// What is expected of the coefficients of a discrepancy at given parameters, in the coordinates of
// a fit. Thread-safe: a pure function.

#include <Eigen/Core>

#include "core/fit/coordinate_prior.h"
#include "core/skin/profile/discrepancy.h"

namespace cutis {

// The slope of the coefficients in the coordinates of a fit and what it adds for those that are
// held: coefficients = offset + slope · x.
struct CoefficientLine {
  Eigen::VectorXd offset;
  Eigen::MatrixXd slope;
};
CoefficientLine coefficientLine(const Discrepancy& discrepancy, const CoordinatePrior& coordinates);

}  // namespace cutis
