#include "core/skin/chebyshev_weights.h"

#include <cmath>
#include <numbers>

namespace cutis {

ChebyshevWeights::ChebyshevWeights(double low, double high, int count)
    : centre_(0.5 * (low + high)),
      halfRange_(high > low ? 0.5 * (high - low) : 1.0),
      fromChebyshev_(count, count) {
  for (int k = 0; k < count; ++k) {
    const double angle = std::numbers::pi * (k + 0.5) / count;
    points_.push_back(count == 1 ? centre_ : centre_ - halfRange_ * std::cos(angle));
    // T_j at the point, for points that rise: cos j(π − angle).
    for (int j = 0; j < count; ++j) {
      const double share = (j == 0 ? 1.0 : 2.0) / count;
      fromChebyshev_(k, j) = share * std::cos(j * (std::numbers::pi - angle));
    }
  }
}

ChebyshevWeights::At ChebyshevWeights::at(double x) const {
  const double t = (x - centre_) / halfRange_;
  Eigen::VectorXd values(count()), slopes(count());
  values[0] = 1.0;
  slopes[0] = 0.0;
  for (int j = 1; j < count(); ++j) {
    values[j] = j == 1 ? t : 2.0 * t * values[j - 1] - values[j - 2];
    slopes[j] = j == 1 ? 1.0 : 2.0 * (values[j - 1] + t * slopes[j - 1]) - slopes[j - 2];
  }
  return {fromChebyshev_ * values, fromChebyshev_ * slopes / halfRange_};
}

}  // namespace cutis
