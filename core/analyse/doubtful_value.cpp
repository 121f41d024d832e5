#include "core/analyse/doubtful_value.h"

namespace cutis {
namespace {

constexpr double kBoundShare = 1e-4;  // of a range
constexpr double kMostlyPrior = 0.5;

}  // namespace

bool isAtBound(double value, const ParameterAxis& axis) {
  return value <= kBoundShare * axis.maximum || value >= (1.0 - kBoundShare) * axis.maximum;
}

bool isMostlyPrior(double value, double deviation, const Prior& prior, Parameter parameter) {
  const double inCoordinate = prior.isLog(parameter) ? deviation / value : deviation;
  return !(inCoordinate <= kMostlyPrior * prior.deviation[parameter]);
}

}  // namespace cutis
