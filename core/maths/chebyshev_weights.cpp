#include "core/maths/chebyshev_weights.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/maths/weighted_sums.h"

namespace cutis {

ChebyshevWeights::ChebyshevWeights(double low, double high, int count)
    : centre_(0.5 * (low + high)), halfRange_(high > low ? 0.5 * (high - low) : 1.0) {
  for (int k = 0; k < count; ++k) {
    const double angle = std::numbers::pi * (k + 0.5) / count;
    points_.push_back(count == 1 ? centre_ : centre_ - halfRange_ * std::cos(angle));
    // T_j at the point, for points that rise: cos j(π − angle).
    for (int j = 0; j < count; ++j) {
      const double share = (j == 0 ? 1.0 : 2.0) / count;
      fromChebyshev_.push_back(share * std::cos(j * (std::numbers::pi - angle)));
      fromSlopes_.push_back(fromChebyshev_.back() / halfRange_);
    }
  }
}

ChebyshevWeights::At ChebyshevWeights::at(std::span<const double> x) const {
  const std::size_t terms = points_.size(), columns = x.size();
  // T_j(t) and T_j'(t), [degree][x].
  std::vector<double> values(terms * columns), slopes(terms * columns);
  for (std::size_t i = 0; i < columns; ++i) {
    const double t = (x[i] - centre_) / halfRange_;
    values[i] = 1.0;
    for (std::size_t j = 1; j < terms; ++j) {
      const std::size_t at = j * columns + i;
      if (j == 1) {
        values[at] = t;
        slopes[at] = 1.0;
        continue;
      }
      values[at] = 2.0 * t * values[at - columns] - values[at - 2 * columns];
      slopes[at] =
          2.0 * (values[at - columns] + t * slopes[at - columns]) - slopes[at - 2 * columns];
    }
  }
  At result = {std::vector<double>(values.size()), std::vector<double>(values.size())};
  runWeightedSums(
      {fromChebyshev_.data(), terms, terms, values.data(), columns, result.weights.data()});
  runWeightedSums({fromSlopes_.data(), terms, terms, slopes.data(), columns, result.slopes.data()});
  return result;
}

}  // namespace cutis
