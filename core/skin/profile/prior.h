#pragma once

// What is known of skin before it is measured: a mean and a spread per parameter, and how they go
// together.
//
// The inverse problem is badly conditioned, so an estimate always leans on a prior; here it is
// explicit. Every parameter has a coordinate, in which the prior is normal: its natural logarithm
// or the parameter itself. On the log scale concentrations are log-normal unless listed as linear,
// and the blend, a share and no concentration, stays normal.

#include <array>
#include <string>

#include "core/base/result.h"
#include "core/skin/profile/chromophore_table.h"
#include "core/skin/profile/parameter_axis.h"

namespace cutis {

// Rows and columns indexed by Parameter.
using ParameterMatrix = Eigen::Matrix<double, kParameterCount, kParameterCount>;

// Which rows of the table are linear on either scale.
std::array<bool, kParameterCount> alwaysLinear();

struct Prior {
  PriorScale scale = PriorScale::log;
  ParameterVector mean = ParameterVector::Zero();
  ParameterVector deviation = ParameterVector::Ones();  // positive
  // Which parameters stay linear on the log scale: as PriorScale::linear.
  std::array<bool, kParameterCount> staysLinear = alwaysLinear();
  // Of the coordinates: symmetric, 1 on the diagonal, positive definite.
  ParameterMatrix correlation = ParameterMatrix::Identity();

  // Whether the parameter's coordinate is its logarithm.
  bool isLog(int parameter) const {
    return scale == PriorScale::log && !staysLinear[static_cast<std::size_t>(parameter)];
  }

  // Inverse of the coordinates' covariance D C D, with D the deviations: the quadratic form of the
  // prior. Symmetric to the last bit; 1 / deviation² on the diagonal where nothing is correlated.
  // Precondition: the prior is valid.
  ParameterMatrix precision() const;
};

// Finite means, positive on the log scale; positive deviations; a proper correlation. NaN fails.
// `place` names the source in the error, `prefix` stands in front of its field names ("prior.").
Status validate(const Prior& prior, const std::string& place, const std::string& prefix = {});

}  // namespace cutis
