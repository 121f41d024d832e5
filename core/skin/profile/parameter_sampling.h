#pragma once

// Parameter sets spread evenly over the box of a profile, in the density of its table: cubic axes
// are sampled more densely near zero, where skin is.

#include <vector>

#include "core/skin/profile/parameter_axis.h"

namespace cutis {

// `count` points of an additive recurrence (Roberts' generalised golden ratio), starting at point
// number `first`: different ranges of numbers are independent sets. Deterministic.
std::vector<ParameterVector> sampleBox(const ParameterAxes& axes, int count, int first = 0);

// Two further coordinates of point number `point` (from 0), `which` 0 or 1, between 0 and 1: evenly
// beside those of sampleBox().
double samplePlace(int which, int point);

}  // namespace cutis
