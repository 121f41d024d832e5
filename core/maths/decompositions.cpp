#include "core/maths/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace cutis {

SymmetricEigen symmetricEigen(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

Eigen::MatrixXd rootOfPositive(const Eigen::MatrixXd& a) {
  const Eigen::LDLT<Eigen::MatrixXd> factors(a);
  const Eigen::MatrixXd lower = factors.matrixL();
  const Eigen::VectorXd roots = factors.vectorD().cwiseMax(0.0).cwiseSqrt();
  return factors.transpositionsP().transpose() * (lower * roots.asDiagonal());
}

Eigen::MatrixXd solvePositive(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.ldlt().solve(b);
}

template <int N>
Eigen::Matrix<double, N, 1> solvePositive(const Eigen::Matrix<double, N, N>& a,
                                          const Eigen::Matrix<double, N, 1>& b) {
  return a.ldlt().solve(b);
}

template <int N>
Eigen::Matrix<double, N, N> inverseOfPositive(const Eigen::Matrix<double, N, N>& a) {
  return a.ldlt().solve(Eigen::Matrix<double, N, N>::Identity());
}

template Eigen::Matrix<double, 5, 1> solvePositive(const Eigen::Matrix<double, 5, 5>&,
                                                   const Eigen::Matrix<double, 5, 1>&);
template Eigen::Matrix<double, 5, 5> inverseOfPositive(const Eigen::Matrix<double, 5, 5>&);
template Eigen::Matrix<double, 6, 6> inverseOfPositive(const Eigen::Matrix<double, 6, 6>&);
template Eigen::Matrix<double, 7, 7> inverseOfPositive(const Eigen::Matrix<double, 7, 7>&);

}  // namespace cutis
