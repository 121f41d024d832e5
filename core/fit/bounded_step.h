#pragma once

// The lowest point of a quadratic within the unit box, for the five parameters.

#include <Eigen/Core>

#include "core/fit/spectra_equations.h"

namespace cutis {

struct BoundedStep {
  EquationVector step = EquationVector::Zero();
  // By how much the quadratic falls; 0 where nothing within the box is lower.
  double decrease = 0.0;
};

// Minimises sᵀ H s − 2 gᵀ s over the steps s that keep x + s within [0, 1]: a primal active set, so
// that it never rises on the way. hessian: positive definite. Clipping the free minimum instead
// would move the other coordinates as if the clipped ones had followed, too.
BoundedStep boundedStep(const EquationMatrix& hessian, const EquationVector& downhill,
                        const EquationVector& x);

}  // namespace cutis
