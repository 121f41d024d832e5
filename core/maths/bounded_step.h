#pragma once  // internal to core/maths

// The lowest point of a quadratic within the unit box, for the five parameters and up to two more
// coordinates.

#include <Eigen/Core>

namespace cutis {

template <int N>
struct BoundedStep {
  Eigen::Matrix<double, N, 1> step = Eigen::Matrix<double, N, 1>::Zero();
  // By how much the quadratic falls; 0 where nothing within the box is lower.
  double decrease = 0.0;
};

// Minimises sᵀ H s − 2 gᵀ s over the steps s that keep x + s within [0, 1]: a primal active set, so
// that it never rises on the way. hessian: positive definite. Clipping the free minimum instead
// would move the other coordinates as if the clipped ones had followed, too. N: 5 to 7.
template <int N>
BoundedStep<N> boundedStep(const Eigen::Matrix<double, N, N>& hessian,
                           const Eigen::Matrix<double, N, 1>& downhill,
                           const Eigen::Matrix<double, N, 1>& x);

}  // namespace cutis
