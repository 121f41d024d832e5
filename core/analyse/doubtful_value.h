#pragma once

// Which values of maps were not measured: those that stand at the end of their range, and those
// that the prior alone decides.
//
// Thread-safe: pure functions.

#include "core/skin/profile/parameter_axis.h"
#include "core/skin/profile/prior.h"

namespace cutis {

// Whether a parameter is within 1e-4 of its range of an end of it: the value would lie beyond if it
// could. NaN does not.
bool isAtBound(double value, const ParameterAxis& axis);

// Whether the posterior deviation is above half of the prior's, in the coordinate in which the
// prior is normal. value and deviation: in the parameter's unit. NaN: yes.
bool isMostlyPrior(double value, double deviation, const Prior& prior, Parameter parameter);

}  // namespace cutis
