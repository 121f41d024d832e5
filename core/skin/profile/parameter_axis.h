#pragma once

// A pixel's parameters as one vector, and the ranges they live in.

#include <array>
#include <span>

#include <Eigen/Core>

#include "core/skin/profile/parameter.h"

namespace cutis {

// Indexed by Parameter.
using ParameterVector = Eigen::Array<double, kParameterCount, 1>;

// Where as many parameters are taken as the profile has (core/skin/profile/profile.h); refers to
// the vector.
inline std::span<const double> asSpan(const ParameterVector& parameters) {
  return {parameters.data(), static_cast<std::size_t>(kParameterCount)};
}

// One parameter's range and the samples it has in the table of skin (paper, Table 2 and eq. 7):
// value(i) = maximum · (i / N)^exponent for i = 0…N.
struct ParameterAxis {
  double maximum = 1.0;  // the minimum is 0
  int samples = 2;       // N + 1, at least 2
  int exponent = 1;      // 1 uniform, 2 quadratic, 3 cubic

  double value(double index) const;
  // Inverse of value(); index of the range's end for values beyond it.
  double index(double value) const;
  double clamp(double value) const;
};

using ParameterAxes = std::array<ParameterAxis, kParameterCount>;

}  // namespace cutis
