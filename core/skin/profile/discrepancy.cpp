#include "core/skin/profile/discrepancy.h"

#include <Eigen/Cholesky>

namespace cutis {
std::string surfaceLightName(SurfaceLight surface) {
  return surface == SurfaceLight::included ? "included" : "removed";
}

std::optional<SurfaceLight> surfaceLightByName(const std::string& name) {
  for (const SurfaceLight surface : {SurfaceLight::included, SurfaceLight::removed}) {
    if (name == surfaceLightName(surface)) return surface;
  }
  return std::nullopt;
}

Status validate(const Discrepancy& discrepancy, const std::string& place,
                const std::string& prefix) {
  const Eigen::Index count = discrepancy.components.cols();
  if (count < 1 || count > kMaximumCoefficients) {
    return inputError(place, prefix + "components must be 1 to " +
                                 std::to_string(kMaximumCoefficients) + " spectra");
  }
  const bool fits =
      discrepancy.components.rows() == kSampleCount && discrepancy.slope.rows() == count &&
      discrepancy.slope.cols() == kParameterCount && discrepancy.covariance.rows() == count &&
      discrepancy.covariance.cols() == count &&
      (discrepancy.rest.cols() == 0 || discrepancy.rest.rows() == kSampleCount);
  if (!fits) {
    return inputError(place, prefix +
                                 "slope and covariance must have a row for each component, and all "
                                 "spectra the same length");
  }
  if (!discrepancy.components.allFinite() || !discrepancy.slope.allFinite() ||
      !discrepancy.covariance.allFinite() || !discrepancy.rest.allFinite()) {
    return inputError(place, prefix + "components must be finite, and all numbers beside them");
  }
  if (!(discrepancy.independentDeviation >= 0.0).all() ||
      !discrepancy.independentDeviation.isFinite().all()) {
    return inputError(place, prefix + "independent_deviation must be 0 or more everywhere");
  }
  const Spectrum least = 1.0 + discrepancy.mean -
                         kMostCoefficientNorm * discrepancy.components.rowwise().norm().array();
  if (!(least >= kLeastFactor).all() || !discrepancy.mean.isFinite().all()) {
    return inputError(place, prefix +
                                 "mean and components must be such that 1 + mean stays 0.05 above "
                                 "four times their joint size at every wavelength");
  }
  const bool proper = discrepancy.covariance == discrepancy.covariance.transpose() &&
                      discrepancy.covariance.llt().info() == Eigen::Success;
  if (!proper) {
    return inputError(place, prefix + "covariance must be symmetric and positive definite");
  }
  return validate(discrepancy.prior, place, prefix + "prior.");
}

}  // namespace cutis
