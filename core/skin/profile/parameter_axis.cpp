#include "core/skin/profile/parameter_axis.h"

#include <algorithm>
#include <cmath>

namespace cutis {

double ParameterAxis::value(double index) const {
  return maximum * std::pow(index / (samples - 1), exponent);
}

double ParameterAxis::index(double value) const {
  return (samples - 1) * std::pow(clamp(value) / maximum, 1.0 / exponent);
}

double ParameterAxis::clamp(double value) const {
  return std::clamp(value, 0.0, maximum);
}

}  // namespace cutis
