#include "core/fit/spectrum_posterior.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/fit/coefficient_line.h"
#include "core/fit/deviation_limit.h"
#include "core/maths/decompositions.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

// The spectrum, and its derivatives with respect to the coordinates and coefficients.
struct SpectrumPosterior::Linearisation {
  Spectrum reflectance;
  MatrixXd derivatives;  // [sample][unknown]
};

// What the channels tell of the unknowns.
struct SpectrumPosterior::Gain {
  MatrixXd matrix;      // [unknown][channel that sees]
  MatrixXd covariance;  // [unknown][unknown], what stays open
};

SpectrumPosterior::SpectrumPosterior(const SkinModel& model, const FitRecord& record)
    : model_(model),
      rows_(record.responses),
      noise_(record.noise),
      shadingVariance_(record.shading ? *record.shading * *record.shading : 0.0),
      coordinates_(coordinatePrior(record.prior, model.profile().axes, record.fixed)),
      discrepancy_(record.discrepancy ? model.profile().discrepancies.of(record.surface)
                                      : nullptr) {
  for (Index k = 0; k < rows_.rows(); ++k) {
    if ((rows_.row(k) != 0.0).any()) seeing_.push_back(k);
  }
}

MatrixXd SpectrumPosterior::priorCovariance() const {
  const int more = discrepancy_ == nullptr ? 0 : discrepancy_->count();
  MatrixXd covariance = MatrixXd::Zero(kParameterCount + more, kParameterCount + more);
  MatrixXd parameters = solvePositive(MatrixXd(coordinates_.precision),
                                      MatrixXd::Identity(kParameterCount, kParameterCount));
  for (int i = 0; i < kParameterCount; ++i) {
    if (!coordinates_.isFixed[static_cast<std::size_t>(i)]) continue;
    parameters.row(i).setZero();
    parameters.col(i).setZero();
  }
  covariance.topLeftCorner(kParameterCount, kParameterCount) = parameters;
  if (more == 0) return covariance;
  const MatrixXd slope = coefficientLine(*discrepancy_, coordinates_).slope;
  covariance.bottomLeftCorner(more, kParameterCount) = slope * parameters;
  covariance.topRightCorner(kParameterCount, more) = parameters * slope.transpose();
  covariance.bottomRightCorner(more, more) =
      discrepancy_->covariance + slope * parameters * slope.transpose();
  return covariance;
}

SpectrumPosterior::Linearisation SpectrumPosterior::linearise(
    std::span<const double> values) const {
  ParameterVector parameters;
  std::copy_n(values.begin(), kParameterCount, parameters.begin());
  SpectrumJacobian slopes;
  Linearisation at;
  const Spectrum modelled = model_.reflectance(parameters, slopes);
  const int more = discrepancy_ == nullptr ? 0 : discrepancy_->count();
  Spectrum factor = Spectrum::Ones();
  if (more > 0) {
    factor = discrepancy_->factor(
        Eigen::Map<const VectorXd>(values.data() + kParameterCount, Index{more}));
  }
  at.reflectance = modelled * factor;
  at.derivatives.resize(int{kSampleCount}, kParameterCount + more);
  for (int i = 0; i < kParameterCount; ++i) {
    const double perCoordinate =
        coordinates_.isLog[static_cast<std::size_t>(i)] ? parameters[i] : 1.0;
    at.derivatives.col(i) = (slopes.col(i) * factor * perCoordinate).matrix();
  }
  for (int c = 0; c < more; ++c) {
    at.derivatives.col(kParameterCount + c) =
        (modelled * discrepancy_->components.col(c).array()).matrix();
  }
  return at;
}

SpectrumPosterior::Gain SpectrumPosterior::gainAt(const Linearisation& at,
                                                  std::span<const double> channels) const {
  const MatrixXd prior = priorCovariance();
  MatrixXd seen(static_cast<Index>(seeing_.size()), at.derivatives.cols());
  VectorXd noise(seen.rows()), modelled(seen.rows());
  for (Index k = 0; k < seen.rows(); ++k) {
    const Index row = seeing_[static_cast<std::size_t>(k)];
    seen.row(k) = rows_.row(row).matrix() * at.derivatives;
    noise[k] = noise_.variance(channels[static_cast<std::size_t>(row)]);
    modelled[k] = (rows_.row(row).transpose() * at.reflectance).sum();
  }
  MatrixXd system = seen * prior * seen.transpose();
  system += shadingVariance_ * modelled * modelled.transpose();
  system.diagonal() += noise;
  const MatrixXd gained = seen * prior;
  Gain gain;
  gain.matrix = solvePositive(system, gained).transpose();
  const MatrixXd covariance = prior - gain.matrix * gained;
  gain.covariance = 0.5 * (covariance + covariance.transpose());
  return gain;
}

// The variance of the rest, less what the unknowns take up of it through the channels. What varies
// from wavelength to wavelength by itself leaves next to nothing in a channel.
Eigen::ArrayXd SpectrumPosterior::restVariance(const Linearisation& at, const Gain& gain) const {
  const MatrixXd rest = at.reflectance.matrix().asDiagonal() * discrepancy_->rest;
  MatrixXd seen(static_cast<Index>(seeing_.size()), rest.cols());
  for (Index k = 0; k < seen.rows(); ++k)
    seen.row(k) = rows_.row(seeing_[static_cast<std::size_t>(k)]).matrix() * rest;
  const MatrixXd missed = rest - at.derivatives * (gain.matrix * seen);
  return missed.rowwise().squaredNorm().array() +
         (at.reflectance * discrepancy_->independentDeviation).square();
}

MatrixXd SpectrumPosterior::covariance(std::span<const double> channels,
                                       std::span<const double> values) const {
  return gainAt(linearise(values), channels).covariance;
}

SpectrumPosterior::Deviations SpectrumPosterior::deviations(std::span<const double> channels,
                                                            std::span<const double> values) const {
  const Linearisation at = linearise(values);
  const Gain gain = gainAt(at, channels);
  Spectrum variance =
      (at.derivatives * gain.covariance).cwiseProduct(at.derivatives).rowwise().sum().array();
  if (discrepancy_ != nullptr) variance += restVariance(at, gain);
  Deviations found;
  found.reflectance = variance.max(0.0).sqrt();
  for (int i = 0; i < kParameterCount; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double perCoordinate = coordinates_.isLog[k] ? values[k] : 1.0;
    found.parameters[i] =
        limitedDeviation(std::sqrt(std::max(gain.covariance(i, i), 0.0)) * perCoordinate, values[k],
                         model_.profile().axes[k].maximum);
  }
  return found;
}

Spectrum SpectrumPosterior::reflectance(std::span<const double> values) const {
  return linearise(values).reflectance;
}

std::vector<double> SpectrumPosterior::channels(std::span<const double> values) const {
  const VectorXd modelled = rows_.matrix() * reflectance(values).matrix();
  return {modelled.begin(), modelled.end()};
}

}  // namespace cutis
