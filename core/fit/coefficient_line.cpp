#include "core/fit/coefficient_line.h"

#include <cmath>
#include <cstddef>

namespace cutis {
namespace {

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

}  // namespace cutis
