#include "core/maths/bounded_step.h"

#include <algorithm>
#include <array>

#include <Eigen/Cholesky>

namespace cutis {

template <int N>
BoundedStep<N> boundedStep(const Eigen::Matrix<double, N, N>& hessian,
                           const Eigen::Matrix<double, N, 1>& downhill,
                           const Eigen::Matrix<double, N, 1>& x) {
  using Vector = Eigen::Matrix<double, N, 1>;
  // Bounds are taken and left a few times each at most.
  constexpr int kMaximumChanges = 8 * N;
  BoundedStep<N> result;
  Vector& step = result.step;
  const Vector low = -x, high = Vector::Ones() - x;
  const double slight = 1e-15 * downhill.cwiseAbs().maxCoeff();
  std::array<bool, N> held;
  for (int i = 0; i < N; ++i) {
    held[static_cast<std::size_t>(i)] =
        (low[i] >= 0.0 && downhill[i] <= 0.0) || (high[i] <= 0.0 && downhill[i] >= 0.0);
  }
  for (int change = 0; change < kMaximumChanges; ++change) {
    Vector slope = downhill - hessian * step;
    Eigen::Matrix<double, N, N> system = hessian;
    for (int i = 0; i < N; ++i) {
      if (!held[static_cast<std::size_t>(i)]) continue;
      system.row(i).setZero();
      system.col(i).setZero();
      system(i, i) = 1.0;
      slope[i] = 0.0;
    }
    const Vector move = system.ldlt().solve(slope);
    double share = 1.0;
    int blocking = -1;
    for (int i = 0; i < N; ++i) {
      const double room = (move[i] < 0.0 ? low[i] : high[i]) - step[i];
      if (move[i] == 0.0 || move[i] / room < 1.0) continue;
      // room may be 0, where the share is.
      const double own = room / move[i];
      if (blocking >= 0 && own >= share) continue;
      share = own;
      blocking = i;
    }
    step = (step + share * move).cwiseMax(low).cwiseMin(high);
    if (blocking >= 0) {
      step[blocking] = move[blocking] < 0.0 ? low[blocking] : high[blocking];
      held[static_cast<std::size_t>(blocking)] = true;
      continue;
    }
    // The held coordinate that wants back most.
    slope = downhill - hessian * step;
    double most = slight;
    int leaving = -1;
    for (int i = 0; i < N; ++i) {
      if (!held[static_cast<std::size_t>(i)]) continue;
      const double inward = step[i] <= low[i] ? slope[i] : -slope[i];
      if (inward <= most) continue;
      most = inward;
      leaving = i;
    }
    if (leaving < 0) break;
    held[static_cast<std::size_t>(leaving)] = false;
  }
  result.decrease = std::max(0.0, step.dot(2.0 * downhill - hessian * step));
  return result;
}

template BoundedStep<5> boundedStep(const Eigen::Matrix<double, 5, 5>&,
                                    const Eigen::Matrix<double, 5, 1>&,
                                    const Eigen::Matrix<double, 5, 1>&);
template BoundedStep<6> boundedStep(const Eigen::Matrix<double, 6, 6>&,
                                    const Eigen::Matrix<double, 6, 1>&,
                                    const Eigen::Matrix<double, 6, 1>&);
template BoundedStep<7> boundedStep(const Eigen::Matrix<double, 7, 7>&,
                                    const Eigen::Matrix<double, 7, 1>&,
                                    const Eigen::Matrix<double, 7, 1>&);

}  // namespace cutis
