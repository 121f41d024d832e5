#include "core/fit/assumed_noise.h"

#include <algorithm>

#include <Eigen/QR>

namespace cutis {
namespace {

constexpr double kNodeTolerance = 1e-5;
constexpr double kExactNodeTolerance = 1e-6;
// The same where there are fewer channels than values to find, coefficients of a discrepancy
// included: what is known beforehand then decides along a curved valley, which the fit can only
// follow if it is not all too narrow. Channels are met to a small
// part of this.
constexpr double kExactNoiseOfFewChannels = 1e-5;
// A channel within this share of a mixture of the others adds nothing of its own.
constexpr double kSameChannel = 1e-6;

}  // namespace

bool asksForExact(const Rig& rig, const FitOptions& options) {
  return options.noise.value_or(rig.noise).isExact();
}

int unknownCount(const FitOptions& options) {
  const auto fixed = std::count_if(options.fixed.begin(), options.fixed.end(),
                                   [](const auto& value) { return value.has_value(); });
  return kParameterCount - static_cast<int>(fixed) + options.free.count();
}

int seeingChannelCount(const Rig& rig) {
  return static_cast<int>((responseRows(rig) != 0.0).rowwise().any().count());
}

int independentChannelCount(const Rig& rig) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(responseRows(rig).matrix().transpose());
  factors.setThreshold(kSameChannel);
  return static_cast<int>(factors.rank());
}

NoiseModel assumedNoise(const Rig& rig, const FitOptions& options) {
  NoiseModel noise = options.noise.value_or(rig.noise);
  const bool priorDecides =
      asksForExact(rig, options) &&
      (options.discrepancy.value_or(false) || seeingChannelCount(rig) < unknownCount(options));
  noise.read = std::max(noise.read, priorDecides ? kExactNoiseOfFewChannels : kExactNoise);
  return noise;
}

double nodeTolerance(const Rig& rig, const FitOptions& options) {
  return asksForExact(rig, options) ? kExactNodeTolerance : kNodeTolerance;
}

}  // namespace cutis
