#pragma once

// The prior as an estimate sees it: normal in one coordinate per parameter, its natural logarithm
// or the parameter itself, with parameters that are held taken out.
//
// A held parameter's coordinate is the parameter, since it may be 0; what its value says of the
// others through the prior's correlations goes into their mean and precision.

#include <array>
#include <optional>

#include "core/skin/profile/prior.h"

namespace cutis {

// The log scale ends here, as a share of the parameter's range: far below what can be measured.
inline constexpr double kSmallestShare = 1e-7;

struct CoordinatePrior {
  std::array<bool, kParameterCount> isLog = {};
  std::array<bool, kParameterCount> isFixed = {};
  ParameterVector low, high;  // the box
  ParameterVector mean;       // of a held parameter: where it is held
  ParameterMatrix precision;  // no coupling with held parameters
  ParameterVector deviation;  // of each coordinate by itself

  double coordinate(int parameter, double value) const;

 private:
  friend CoordinatePrior coordinatePrior(
      const Prior& prior, const ParameterAxes& axes,
      const std::array<std::optional<double>, kParameterCount>& fixed);
  ParameterVector smallest_;
};

// Precondition: validate(prior) passed.
CoordinatePrior coordinatePrior(const Prior& prior, const ParameterAxes& axes,
                                const std::array<std::optional<double>, kParameterCount>& fixed);

}  // namespace cutis
