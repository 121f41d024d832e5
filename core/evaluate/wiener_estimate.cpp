#include "core/evaluate/wiener_estimate.h"

#include <algorithm>

#include <Eigen/Cholesky>

#include "core/fit/assumed_noise.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Channels, and products of channel i and j ≥ i below them.
MatrixXd featuresOf(WienerFeatures features, const MatrixXd& channels) {
  if (features == WienerFeatures::channels) return channels;
  const Index count = channels.rows();
  MatrixXd all(count + count * (count + 1) / 2, channels.cols());
  all.topRows(count) = channels;
  Index row = count;
  for (Index i = 0; i < count; ++i) {
    for (Index j = i; j < count; ++j, ++row)
      all.row(row) = channels.row(i).cwiseProduct(channels.row(j));
  }
  return all;
}

// The variance of the features of one spectrum, to first order.
VectorXd varianceOf(WienerFeatures features, const VectorXd& channels, const NoiseModel& noise) {
  const VectorXd own = channels.unaryExpr([&](double channel) { return noise.variance(channel); });
  if (features == WienerFeatures::channels) return own;
  const Index count = channels.size();
  VectorXd all(count + count * (count + 1) / 2);
  all.head(count) = own;
  Index row = count;
  for (Index i = 0; i < count; ++i) {
    for (Index j = i; j < count; ++j, ++row) {
      const double yi = channels[i], yj = channels[j];
      all[row] = i == j ? 4.0 * yi * yi * own[i] : yi * yi * own[j] + yj * yj * own[i];
    }
  }
  return all;
}

}  // namespace

WienerEstimate::WienerEstimate(WienerFeatures features, const MatrixXd& channels,
                               const MatrixXd& spectra, const NoiseModel& noise)
    : features_(features) {
  NoiseModel assumed = noise;
  assumed.read = std::max(assumed.read, kExactNoise);
  const auto count = static_cast<double>(channels.cols());
  MatrixXd inputs = featuresOf(features, channels);
  meanFeatures_ = inputs.rowwise().mean();
  meanSpectrum_ = spectra.rowwise().mean();
  inputs.colwise() -= meanFeatures_;
  const MatrixXd outputs = spectra.colwise() - meanSpectrum_;
  VectorXd variance = VectorXd::Zero(inputs.rows());
  for (Index i = 0; i < channels.cols(); ++i)
    variance += varianceOf(features, channels.col(i), assumed) / count;
  MatrixXd covariance = inputs * inputs.transpose() / count;
  covariance.diagonal() += variance;
  const MatrixXd across = inputs * outputs.transpose() / count;
  gain_ = covariance.ldlt().solve(across).transpose();
}

MatrixXd WienerEstimate::estimate(const MatrixXd& channels) const {
  const MatrixXd inputs = featuresOf(features_, channels).colwise() - meanFeatures_;
  return (gain_ * inputs).colwise() + meanSpectrum_;
}

}  // namespace cutis
