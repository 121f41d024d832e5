#include "core/fit/coordinate_prior.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Cholesky>

namespace cutis {
namespace {

// Mean and precision of the parameters in `free`, given where the others are.
void condition(const std::vector<int>& free, const ParameterVector& away,
               const ParameterMatrix& precision, CoordinatePrior& conditioned) {
  const auto count = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd among(count, count);
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(count);
  for (Eigen::Index a = 0; a < count; ++a) {
    const int i = free[static_cast<std::size_t>(a)];
    for (Eigen::Index b = 0; b < count; ++b) {
      among(a, b) = precision(i, free[static_cast<std::size_t>(b)]);
    }
    for (int j = 0; j < kParameterCount; ++j)
      pull[a] -= precision(i, j) * away[j];
  }
  const Eigen::MatrixXd covariance = among.llt().solve(Eigen::MatrixXd::Identity(count, count));
  const Eigen::VectorXd shift = covariance * pull;
  for (Eigen::Index a = 0; a < count; ++a) {
    const int i = free[static_cast<std::size_t>(a)];
    conditioned.mean[i] += shift[a];
    conditioned.deviation[i] = std::sqrt(covariance(a, a));
    for (Eigen::Index b = 0; b < count; ++b) {
      conditioned.precision(i, free[static_cast<std::size_t>(b)]) = among(a, b);
    }
  }
}

}  // namespace

double CoordinatePrior::coordinate(int parameter, double value) const {
  return isLog[static_cast<std::size_t>(parameter)]
             ? std::log(std::max(value, smallest_[parameter]))
             : value;
}

CoordinatePrior coordinatePrior(const Prior& prior, const ParameterAxes& axes,
                                const std::array<std::optional<double>, kParameterCount>& fixed) {
  CoordinatePrior conditioned;
  conditioned.precision = ParameterMatrix::Identity();
  conditioned.deviation = prior.deviation;
  std::vector<int> free;
  ParameterVector away = ParameterVector::Zero();  // of held parameters, in the prior's coordinates
  for (int i = 0; i < kParameterCount; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const double maximum = axes[index].maximum;
    conditioned.smallest_[i] = kSmallestShare * maximum;
    conditioned.isLog[index] = prior.isLog(i);
    const double mean = conditioned.coordinate(i, prior.mean[i]);
    if (fixed[index]) away[i] = conditioned.coordinate(i, *fixed[index]) - mean;
    conditioned.isFixed[index] = fixed[index].has_value();
    if (fixed[index]) conditioned.isLog[index] = false;
    conditioned.low[i] = conditioned.coordinate(i, 0.0);
    conditioned.high[i] = conditioned.coordinate(i, maximum);
    conditioned.mean[i] = fixed[index].value_or(mean);
    if (!fixed[index]) free.push_back(i);
  }
  if (!free.empty()) condition(free, away, prior.precision(), conditioned);
  return conditioned;
}

}  // namespace cutis
