#pragma once

// Gaussian quadrature on an interval: Σ weight f(node) in place of ∫ f.
//
// Nodes and weights of n points come from the eigenvectors of the Jacobi matrix of the Legendre
// polynomials (Golub & Welsch 1969; Golub 1973 for the fixed end): exact to about 1e-15, nodes
// rising, weights positive with the interval's length for their sum. Precondition: n ≥ 1, from <
// to. Thread-safe. O(n³); made once per set of streams.

#include <Eigen/Core>

namespace cutis {

struct Quadrature {
  Eigen::ArrayXd nodes;
  Eigen::ArrayXd weights;
};

// Gauss–Legendre: exact for polynomials up to degree 2n − 1; all nodes inside.
Quadrature gaussQuadrature(int points, double from, double to);

// Gauss–Radau: exact up to degree 2n − 2; the last node is the upper end.
Quadrature radauQuadrature(int points, double from, double to);

}  // namespace cutis
