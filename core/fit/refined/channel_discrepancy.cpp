#include "core/fit/refined/channel_discrepancy.h"

#include <cmath>

namespace cutis {
namespace {

using Eigen::Index;

// A coordinate of the fit and of the discrepancy's own prior may be the logarithm in one and the
// parameter itself in the other: the line is then continued as a tangent at the prior's mean.
struct Axis {
  double mean = 0.0;        // of the prior, in the fit's coordinate
  double perFitUnit = 1.0;  // slope of the discrepancy's coordinate by the fit's
};

Axis axisOf(const Prior& own, int parameter, bool fitIsLog) {
  const double mean = own.mean[parameter];
  if (own.isLog(parameter)) {
    return fitIsLog ? Axis{std::log(mean), 1.0} : Axis{mean, 1.0 / mean};
  }
  return fitIsLog && mean > 0.0 ? Axis{std::log(mean), mean} : Axis{mean, 1.0};
}

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

CoefficientLine coefficientLine(const Discrepancy& discrepancy,
                                const CoordinatePrior& coordinates) {
  CoefficientLine line = {Eigen::VectorXd::Zero(discrepancy.count()),
                          Eigen::MatrixXd::Zero(discrepancy.count(), kParameterCount)};
  for (int i = 0; i < kParameterCount; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const bool held = coordinates.isFixed[index];
    const bool isLog =
        held ? discrepancy.prior.isLog(i) && coordinates.mean[i] > 0.0 : coordinates.isLog[index];
    const Axis axis = axisOf(discrepancy.prior, i, isLog);
    const Eigen::VectorXd slope = discrepancy.slope.col(i) * axis.perFitUnit;
    if (held) {
      const double value = isLog ? std::log(coordinates.mean[i]) : coordinates.mean[i];
      line.offset += slope * (value - axis.mean);
    } else {
      line.offset -= slope * axis.mean;
      line.slope.col(i) = slope;
    }
  }
  return line;
}

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
