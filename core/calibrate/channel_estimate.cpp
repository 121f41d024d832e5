#include "core/calibrate/channel_estimate.h"

#include "core/maths/decompositions.h"
#include "core/skin/model/choose_nodes.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

ChannelEstimator::ChannelEstimator(const SkinModel& model, const SpectrumRows& rows, double noise,
                                   const Prior& prior,
                                   const std::optional<Discrepancy>& discrepancy)
    : model_(model),
      like_(discrepancy ? discrepancy->prior : prior),
      prior_(coordinatePrior(like_, model.profile().axes, {})),
      discrepancy_(discrepancy) {
  const Index count = rows.rows();
  MatrixXd covariance = noise * noise * MatrixXd::Identity(count, count);
  slopes_ = MatrixXd::Zero(count, kParameterCount);
  SpectrumRows seen = rows;
  if (discrepancy_) {
    seen.rowwise() *= (1.0 + discrepancy_->mean).transpose();
    const Spectrum typical = model.reflectance(like_.mean);
    const MatrixXd weights = rows.matrix() * typical.matrix().asDiagonal();
    const VectorXd channels = seen.matrix() * typical.matrix();
    components_ = channels.cwiseInverse().asDiagonal() * (weights * discrepancy_->components);
    slopes_ = components_ * discrepancy_->slope;
    covariance += components_ * discrepancy_->covariance * components_.transpose();
  }
  nodes_ = chooseNodes(model, seen);
  precision_ = solvePositive(covariance, MatrixXd::Identity(count, count));
}

Spectrum ChannelEstimator::reflectance(const VectorXd& channels) const {
  const FoundCoordinates found = searchCoordinates(
      prior_, [&](const Coordinates& coordinates) { return equations(channels, coordinates); });
  const Spectrum modelled = model_.reflectance(parametersOf(like_, found.coordinates));
  if (!discrepancy_) return modelled;
  const VectorXd coefficients = discrepancy_->slope * (found.coordinates - prior_.mean.matrix()) +
                                discrepancy_->covariance * components_.transpose() * precision_ *
                                    residual(channels, found.coordinates);
  return modelled * discrepancy_->factor(coefficients);
}

CoordinateEquations ChannelEstimator::equations(const VectorXd& channels,
                                                const Coordinates& coordinates) const {
  const ParameterVector parameters = parametersOf(like_, coordinates);
  const auto count = static_cast<Index>(nodes_.samples.size());
  MatrixXd byCoordinate(count, kParameterCount);
  for (Index n = 0; n < count; ++n) {
    ParameterVector row;
    model_.reflectanceAt(nodes_.samples[static_cast<std::size_t>(n)], parameters, row);
    for (int k = 0; k < kParameterCount; ++k)
      byCoordinate(n, k) = like_.isLog(k) ? row[k] * parameters[k] : row[k];
  }
  const MatrixXd slopes =
      channels.cwiseInverse().asDiagonal() * (nodes_.weights * byCoordinate) + slopes_;
  const VectorXd misfit = residual(channels, coordinates);
  CoordinateEquations sums;
  sums.hessian = slopes.transpose() * precision_ * slopes;
  sums.downhill = slopes.transpose() * precision_ * misfit;
  sums.cost = misfit.dot(precision_ * misfit);
  addPrior(prior_, coordinates, sums);
  return sums;
}

VectorXd ChannelEstimator::residual(const VectorXd& channels,
                                    const Coordinates& coordinates) const {
  const ParameterVector parameters = parametersOf(like_, coordinates);
  VectorXd reflectances(static_cast<Index>(nodes_.samples.size()));
  for (Index n = 0; n < reflectances.size(); ++n) {
    reflectances[n] = model_.reflectanceAt(nodes_.samples[static_cast<std::size_t>(n)], parameters);
  }
  return VectorXd::Ones(channels.size()) - (nodes_.weights * reflectances).cwiseQuotient(channels) -
         slopes_ * (coordinates - prior_.mean.matrix());
}

}  // namespace cutis
