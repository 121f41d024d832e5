#pragma once

// What is known of skin before it is measured: a mean and a spread per parameter.
//
// The inverse problem is badly conditioned, so an estimate always leans on a prior; here it is
// explicit. On the log scale the four concentrations are log-normal and the blend stays normal.

#include "core/skin/parameter_axis.h"

namespace cutis {

enum class PriorScale {
  linear,  // mean and deviation in the parameter's own unit
  log,     // mean: the median, in the parameter's own unit; deviation: of its natural logarithm.
           // The blend, a share and no concentration, is as in `linear`.
};

struct Prior {
  PriorScale scale = PriorScale::log;
  ParameterVector mean = ParameterVector::Zero();
  ParameterVector deviation = ParameterVector::Ones();  // positive

  bool isLog(int parameter) const {
    return scale == PriorScale::log && parameter != kMelaninBlend;
  }
};

}  // namespace cutis
