#pragma once

// Parameter sets spread evenly over the box of a profile, in the density of its table: cubic axes
// are sampled more densely near zero, where skin is.

#include "core/skin/parameter_axis.h"

#include <vector>

namespace cutis {

// `count` points of an additive recurrence (Roberts' generalised golden ratio), starting at point
// number `first`: different ranges of numbers are independent sets. Deterministic.
std::vector<ParameterVector> sampleBox(const ParameterAxes& axes, int count, int first = 0);

}  // namespace cutis
