#include "core/fit/reference/map_estimator.h"

#include <algorithm>
#include <cmath>

#include "core/fit/assumed_noise.h"
#include "core/fit/coordinate_prior.h"
#include "core/maths/decompositions.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Convergence: the step would lower the cost by less than this share of one standard deviation².
constexpr double kDecrement = 1e-10;

}  // namespace

// The lowest point of the quadratic model within the box, by fixing each coordinate that would
// leave it to its bound and solving again for the others. Clipping the step instead would stall:
// the others would move as if the clipped ones had, too.
ParameterVector MapEstimator::stepWithinBox(const ParameterMatrix& hessian,
                                            const ParameterVector& downhill,
                                            const ParameterVector& x,
                                            std::array<bool, kParameterCount> held) const {
  ParameterVector step = ParameterVector::Zero();
  for (int attempt = 0; attempt <= kParameterCount; ++attempt) {
    ParameterMatrix system = hessian;
    Eigen::Matrix<double, kParameterCount, 1> right = downhill.matrix();
    for (int i = 0; i < kParameterCount; ++i) {
      if (held[static_cast<std::size_t>(i)]) right -= hessian.col(i) * step[i];
    }
    for (int i = 0; i < kParameterCount; ++i) {
      if (!held[static_cast<std::size_t>(i)]) continue;
      system.row(i).setZero();
      system.col(i).setZero();
      system(i, i) = 1.0;
      right[i] = step[i];
    }
    step = solvePositive<kParameterCount>(system, right).array();
    bool crossed = false;
    for (int i = 0; i < kParameterCount; ++i) {
      const double target = x[i] + step[i];
      const double inside = std::clamp(target, low_[i], high_[i]);
      if (held[static_cast<std::size_t>(i)] || inside == target) continue;
      step[i] = inside - x[i];
      held[static_cast<std::size_t>(i)] = true;
      crossed = true;
    }
    if (!crossed) break;
  }
  return step;
}

MapEstimator::MapEstimator(const SkinModel& model, SpectralNodes nodes,
                           const EstimatorOptions& options)
    : model_(model),
      instrument_(model, options.geometry),
      nodes_(std::move(nodes)),
      options_(options) {
  options_.noise.read = std::max(options_.noise.read, kExactNoise);
  if (options_.prior) priorPrecision_ = options_.prior->precision();
  for (Index k = 0; k < nodes_.weights.rows(); ++k) {
    alive_.push_back((nodes_.weights.row(k).array() != 0.0).any());
  }
  for (int i = 0; i < kParameterCount; ++i) {
    const double maximum = model_.profile().axes[static_cast<std::size_t>(i)].maximum;
    low_[i] = isLog(i) ? std::log(kSmallestShare * maximum) : 0.0;
    high_[i] = coordinate(i, maximum);
    if (options_.prior) {
      priorMean_[i] = coordinate(i, options_.prior->mean[i]);
    } else {
      priorMean_[i] = 0.5 * (low_[i] + high_[i]);
    }
  }
}

double MapEstimator::coordinate(int parameter, double value) const {
  if (!isLog(parameter)) return value;
  const double maximum = model_.profile().axes[static_cast<std::size_t>(parameter)].maximum;
  return std::log(std::max(value, kSmallestShare * maximum));
}

ParameterVector MapEstimator::parametersAt(const ParameterVector& coordinates) const {
  ParameterVector parameters;
  for (int i = 0; i < kParameterCount; ++i) {
    parameters[i] = isLog(i) ? std::exp(coordinates[i]) : coordinates[i];
  }
  return parameters;
}

MapEstimator::Linearisation MapEstimator::linearise(const ParameterVector& coordinates) const {
  const ParameterVector parameters = parametersAt(coordinates);
  const auto count = static_cast<Index>(nodes_.samples.size());
  VectorXd reflectance(count);
  Eigen::Matrix<double, Eigen::Dynamic, kParameterCount> slopes(count, kParameterCount);
  for (Index n = 0; n < count; ++n) {
    ParameterVector row;
    reflectance[n] =
        instrument_.reflectanceAt(nodes_.samples[static_cast<std::size_t>(n)], parameters, row);
    for (int i = 0; i < kParameterCount; ++i) {
      slopes(n, i) = isLog(i) ? row[i] * parameters[i] : row[i];
    }
  }
  return {nodes_.weights * reflectance, nodes_.weights * slopes};
}

double MapEstimator::cost(const VectorXd& channels, const VectorXd& precision,
                          const ParameterVector& coordinates) const {
  const ParameterVector parameters = parametersAt(coordinates);
  VectorXd reflectance(static_cast<Index>(nodes_.samples.size()));
  for (Index n = 0; n < reflectance.size(); ++n) {
    reflectance[n] =
        instrument_.reflectanceAt(nodes_.samples[static_cast<std::size_t>(n)], parameters);
  }
  const VectorXd residual = channels - nodes_.weights * reflectance;
  double sum = (precision.array() * residual.array().square()).sum();
  const Eigen::Matrix<double, kParameterCount, 1> away = (coordinates - priorMean_).matrix();
  return sum + away.dot(priorPrecision_ * away);
}

Estimate MapEstimator::solve(const VectorXd& channels) const {
  return solve(channels, parametersAt(priorMean_));
}

Estimate MapEstimator::solve(const VectorXd& channels, const ParameterVector& start) const {
  VectorXd precision(channels.size());
  for (Index k = 0; k < channels.size(); ++k) {
    const double variance = options_.noise.variance(channels[k]);
    precision[k] = alive_[static_cast<std::size_t>(k)] ? 1.0 / variance : 0.0;
  }
  std::array<bool, kParameterCount> fixed;
  ParameterVector x;
  for (int i = 0; i < kParameterCount; ++i) {
    const auto& value = options_.fixed[static_cast<std::size_t>(i)];
    fixed[static_cast<std::size_t>(i)] = value.has_value();
    // A fixed value counts as it is, even 0 on the log scale.
    x[i] = value ? coordinate(i, *value) : std::clamp(coordinate(i, start[i]), low_[i], high_[i]);
  }

  Estimate estimate;
  double damping = 0.0;
  double current = cost(channels, precision, x);
  ParameterMatrix hessian;
  VectorXd residual;
  for (;; ++estimate.iterations) {
    const Linearisation at = linearise(x);
    residual = channels - at.modelled;
    hessian = at.jacobian.transpose() * precision.asDiagonal() * at.jacobian;
    hessian += priorPrecision_;
    const Eigen::Matrix<double, kParameterCount, 1> downhill =
        at.jacobian.transpose() * precision.asDiagonal() * residual -
        priorPrecision_ * (x - priorMean_).matrix();
    if (estimate.converged || estimate.iterations >= options_.maximumIterations) break;

    // Coordinates that stay: fixed ones, and those at a bound that want to leave the box.
    std::array<bool, kParameterCount> held = fixed;
    for (int i = 0; i < kParameterCount; ++i) {
      const bool outward =
          (x[i] <= low_[i] && downhill[i] <= 0.0) || (x[i] >= high_[i] && downhill[i] >= 0.0);
      if (outward) held[static_cast<std::size_t>(i)] = true;
    }
    bool accepted = false;
    while (!accepted) {
      ParameterMatrix damped = hessian;
      damped.diagonal() *= 1.0 + damping;
      const ParameterVector step = stepWithinBox(damped, downhill.array(), x, held);
      // What the quadratic model promises.
      const double decrease =
          (step * (2.0 * downhill.array() - (damped * step.matrix()).array())).sum();
      if (decrease < kDecrement || damping > 1e12) {
        estimate.converged = true;
        break;
      }
      const ParameterVector next = (x + step).max(low_).min(high_);
      const double value = cost(channels, precision, next);
      if (value <= current) {
        x = next;
        current = value;
        damping = damping < 1e-9 ? 0.0 : damping * 0.1;
        accepted = true;
      } else {
        damping = damping == 0.0 ? 1e-4 : damping * 10.0;
      }
    }
  }

  estimate.parameters = parametersAt(x);
  for (int i = 0; i < kParameterCount; ++i) {
    const auto index = static_cast<std::size_t>(i);
    if (fixed[index]) {
      estimate.parameters[i] = *options_.fixed[index];
      hessian.row(i).setZero();
      hessian.col(i).setZero();
      hessian(i, i) = 1.0;
    }
  }
  estimate.covariance = inverseOfPositive<kParameterCount>(hessian);
  for (int i = 0; i < kParameterCount; ++i) {
    const double deviation = std::sqrt(std::max(0.0, estimate.covariance(i, i)));
    estimate.deviations[i] = isLog(i) ? deviation * estimate.parameters[i] : deviation;
    if (fixed[static_cast<std::size_t>(i)]) {
      estimate.covariance.row(i).setZero();
      estimate.covariance.col(i).setZero();
      estimate.deviations[i] = 0.0;
    }
  }
  estimate.residual = residual;
  estimate.cost = current;
  return estimate;
}

}  // namespace cutis
