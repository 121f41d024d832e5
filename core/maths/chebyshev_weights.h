#pragma once

// A smooth function of one variable from its values at a few points: the polynomial through the
// Chebyshev points of a range, as weights of those values.

#include <span>
#include <vector>

namespace cutis {

// Thread-safe: const after construction.
class ChebyshevWeights {
 public:
  // count ≥ 1, low ≤ high. One point lies in the middle and stands for all of the range.
  ChebyshevWeights(double low, double high, int count);

  int count() const { return static_cast<int>(points_.size()); }
  const std::vector<double>& points() const { return points_; }

  // The weights for many x, [point][x]: f(x) = Σ weights[k] f(points[k]) and f'(x) = Σ slopes[k]
  // f(points[k]). NaN gives NaN; each x for itself.
  struct At {
    std::vector<double> weights, slopes;
  };
  At at(std::span<const double> x) const;

 private:
  double centre_;
  double halfRange_;
  std::vector<double> points_;
  std::vector<double> fromChebyshev_;  // [point][degree]
  std::vector<double> fromSlopes_;     // the same, by x
};

}  // namespace cutis
