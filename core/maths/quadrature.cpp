#include "core/maths/quadrature.h"

#include <cassert>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace cutis {
namespace {

// Jacobi matrix of the Legendre polynomials on [−1, 1]: zero diagonal, k / √(4k² − 1) beside it.
double besideDiagonal(int k) {
  return k / std::sqrt(4.0 * k * k - 1.0);
}

// The last entry of the diagonal that makes the upper end an eigenvalue: 1 − b² p(1) with p the
// ratio of the last two orthonormal polynomials there, by their recurrence.
double entryForUpperEnd(int points) {
  double ratio = 0.0;
  for (int k = 1; k < points; ++k) {
    const double before = k > 1 ? besideDiagonal(k - 1) : 0.0;
    ratio = 1.0 / (1.0 - before * before * ratio);
  }
  const double b = points > 1 ? besideDiagonal(points - 1) : 0.0;
  return 1.0 - b * b * ratio;
}

Quadrature fromJacobiMatrix(int points, double lastEntry, double from, double to) {
  assert(points >= 1 && from < to);
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(points);
  Eigen::VectorXd beside = Eigen::VectorXd::Zero(points - 1);
  diagonal[points - 1] = lastEntry;
  for (int k = 1; k < points; ++k)
    beside[k - 1] = besideDiagonal(k);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::ComputeEigenvectors);
  const double half = 0.5 * (to - from);
  Quadrature rule;
  rule.nodes = 0.5 * (from + to) + half * solver.eigenvalues().array();
  rule.weights = 2.0 * half * solver.eigenvectors().row(0).transpose().array().square();
  return rule;
}

}  // namespace

Quadrature gaussQuadrature(int points, double from, double to) {
  return fromJacobiMatrix(points, 0.0, from, to);
}

Quadrature radauQuadrature(int points, double from, double to) {
  Quadrature rule = fromJacobiMatrix(points, entryForUpperEnd(points), from, to);
  rule.nodes[points - 1] = to;
  return rule;
}

}  // namespace cutis
