#include "core/skin/profile/prior.h"

#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace cutis {
namespace {

// Squares of these and of their inverses are still numbers.
constexpr double kLargest = 1e12, kLeastDeviation = 1e-12;

// Below it two combinations of parameters would be known to a thousandth of their deviations: a
// mistake, and too near to singular for single precision.
constexpr double kSmallestEigenvalue = 1e-6;

Status validateParts(const Prior& prior, const std::string& place, const std::string& prefix) {
  for (const Parameter parameter : kParameters) {
    const std::string name(parameterName(parameter));
    const double mean = prior.mean[parameter], deviation = prior.deviation[parameter];
    if (!(std::abs(mean) <= kLargest)) {
      return inputError(place, prefix + "mean." + name + " must be finite and at most 1e12");
    }
    if (prior.isLog(parameter) && !(mean > 0.0)) {
      return inputError(place, prefix + "mean." + name + " must be positive on the log scale");
    }
    if (!(deviation >= kLeastDeviation && deviation <= kLargest)) {
      return inputError(place, prefix + "sd." + name + " must be positive, from 1e-12 to 1e12");
    }
  }
  return {};
}

}  // namespace

std::array<bool, kParameterCount> alwaysLinear() {
  std::array<bool, kParameterCount> linear;
  for (std::size_t k = 0; k < linear.size(); ++k)
    linear[k] = chromophoreTable()[k].priorScale == PriorScale::linear;
  return linear;
}

ParameterMatrix Prior::precision() const {
  const ParameterMatrix inverse = correlation.llt().solve(ParameterMatrix::Identity());
  const auto unit = deviation.inverse().matrix().asDiagonal();
  const ParameterMatrix scaled = unit * inverse * unit;
  return 0.5 * (scaled + scaled.transpose());
}

Status validate(const Prior& prior, const std::string& place, const std::string& prefix) {
  CUTIS_CHECK(validateParts(prior, place, prefix));
  const ParameterMatrix& c = prior.correlation;
  const bool proper = c.allFinite() && c == c.transpose() && (c.diagonal().array() == 1.0).all();
  if (!proper) {
    return inputError(place,
                      prefix + "correlation must be finite and symmetric with a diagonal of 1");
  }
  const Eigen::SelfAdjointEigenSolver<ParameterMatrix> solver(c, Eigen::EigenvaluesOnly);
  if (!(solver.eigenvalues().minCoeff() >= kSmallestEigenvalue)) {
    return inputError(place, prefix +
                                 "correlation must be positive definite, but these correlations "
                                 "contradict one another; bring them nearer to 0");
  }
  return {};
}

}  // namespace cutis
