#pragma once

// The most probable coordinates of one person under a normal distribution of them, by damped
// Gauss–Newton steps within a profile's ranges.

#include <functional>

#include "core/calibrate/discrepancy/coordinate_distribution.h"
#include "core/fit/coordinate_prior.h"
#include "core/maths/equation_sums.h"

namespace cutis {

using CoordinateEquations = EquationsOf<kParameterCount>;

struct FoundCoordinates {
  Coordinates coordinates = Coordinates::Zero();
  CoordinateEquations equations;  // there
  bool converged = false;
};

// From the prior's mean. equations: those of the misfit and of the prior together, in units of
// variances.
FoundCoordinates searchCoordinates(
    const CoordinatePrior& box,
    const std::function<CoordinateEquations(const Coordinates&)>& equations);

// What the prior adds to the equations of a misfit.
void addPrior(const CoordinatePrior& prior, const Coordinates& coordinates,
              CoordinateEquations& equations);

}  // namespace cutis
