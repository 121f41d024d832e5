#include "core/fit/refined/channel_discrepancy.h"

#include "core/fit/coefficient_line.h"

namespace cutis {
namespace {

using Eigen::Index;

// What each channel sees of a relative change at each wavelength, at the prior's mean.
Eigen::MatrixXd channelShares(const Discrepancy& discrepancy, const SkinModel& model,
                              const SpectrumRows& rows) {
  const Spectrum reflectance = model.reflectance(discrepancy.prior.mean);
  const Spectrum seen = reflectance * (1.0 + discrepancy.mean);
  Eigen::MatrixXd shares(rows.rows(), int{kSampleCount});
  for (Index k = 0; k < rows.rows(); ++k) {
    const double channel = (rows.row(k).transpose() * seen).sum();
    shares.row(k).setZero();
    if (channel > 0.0)
      shares.row(k) = (rows.row(k).transpose() * reflectance / channel).matrix().transpose();
  }
  return shares;
}

}  // namespace

ChannelDiscrepancy channelDiscrepancy(const Discrepancy& discrepancy, const SkinModel& model,
                                      const SpectrumRows& rows,
                                      const CoordinatePrior& coordinates) {
  ChannelDiscrepancy seen;
  const CoefficientLine line = coefficientLine(discrepancy, coordinates);
  seen.perCoefficient = channelShares(discrepancy, model, rows) * discrepancy.components;
  seen.offset = seen.perCoefficient * line.offset;
  seen.slope = seen.perCoefficient * line.slope;
  seen.covariance = seen.perCoefficient * discrepancy.covariance * seen.perCoefficient.transpose();
  seen.coefficientOffset = line.offset;
  seen.coefficientSlope = line.slope;
  seen.coefficientCovariance = discrepancy.covariance;
  seen.gain = discrepancy.covariance * seen.perCoefficient.transpose();
  return seen;
}

}  // namespace cutis
