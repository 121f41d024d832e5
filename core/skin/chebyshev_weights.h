#pragma once

// A smooth function of one variable from its values at a few points: the polynomial through the
// Chebyshev points of a range, as weights of those values.

#include <vector>

#include <Eigen/Core>

namespace cutis {

// Thread-safe: const after construction.
class ChebyshevWeights {
 public:
  // count ≥ 1, low ≤ high. One point lies in the middle and stands for all of the range.
  ChebyshevWeights(double low, double high, int count);

  int count() const { return static_cast<int>(points_.size()); }
  const std::vector<double>& points() const { return points_; }

  // f(x) = Σ weights[k] f(points[k]) and f'(x) = Σ slopes[k] f(points[k]). NaN gives NaN.
  struct At {
    Eigen::VectorXd weights, slopes;
  };
  At at(double x) const;

 private:
  double centre_;
  double halfRange_;
  std::vector<double> points_;
  Eigen::MatrixXd fromChebyshev_;  // [point][degree]
};

}  // namespace cutis
