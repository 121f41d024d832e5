#pragma once

// Systems with symmetric matrices, solved in one place. Compiling Eigen's decompositions takes
// longer than everything else in a file that uses one; these are compiled once.
//
// Only the lower triangle of a symmetric matrix is read. NaN in, NaN out. Thread-safe.

#include <Eigen/Core>

namespace cutis {

// The eigenvalues in increasing order, and the vectors of unit length that belong to them as
// columns.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SymmetricEigen symmetricEigen(const Eigen::MatrixXd& symmetric);

// A factor L of a = L Lᵀ, not triangular; a: positive semi-definite, where what rounding makes
// negative counts as 0.
Eigen::MatrixXd rootOfPositive(const Eigen::MatrixXd& a);

// x of a x = b by LDLᵀ; a: positive semi-definite.
Eigen::MatrixXd solvePositive(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

// The same for the five parameters and up to two constants. N: 5 to 7.
template <int N>
Eigen::Matrix<double, N, 1> solvePositive(const Eigen::Matrix<double, N, N>& a,
                                          const Eigen::Matrix<double, N, 1>& b);
template <int N>
Eigen::Matrix<double, N, N> inverseOfPositive(const Eigen::Matrix<double, N, N>& a);

}  // namespace cutis
