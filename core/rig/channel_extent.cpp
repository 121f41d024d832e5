#include "core/rig/channel_extent.h"

#include <algorithm>
#include <cmath>

namespace cutis {
namespace {

// The samples of one response between its two tails; the sum is positive.
Band betweenTails(const Spectrum& response, double sum) {
  const double tail = kUnmeasuredShare * sum;
  Band band;
  for (double seen = response[0]; seen <= tail && band.first < kSampleCount - 1;)
    seen += response[++band.first];
  for (double seen = response[kSampleCount - 1]; seen <= tail && band.last > 0;)
    seen += response[--band.last];
  return band;
}

}  // namespace

std::optional<ChannelExtent> channelExtent(const Spectrum& response) {
  const double sum = response.sum();
  if (!(sum > 0.0)) return std::nullopt;
  ChannelExtent extent;
  for (int i = 0; i < kSampleCount; ++i)
    extent.effectiveNm += wavelengthNm(i) * response[i] / sum;
  double variance = 0.0;
  for (int i = 0; i < kSampleCount; ++i) {
    const double apart = wavelengthNm(i) - extent.effectiveNm;
    variance += apart * apart * response[i] / sum;
  }
  extent.deviationNm = std::sqrt(variance);
  return extent;
}

std::optional<Band> measuredBand(const SpectrumRows& responses) {
  std::optional<Band> all;
  for (Eigen::Index k = 0; k < responses.rows(); ++k) {
    const Spectrum response = responses.row(k).transpose();
    const double sum = response.sum();
    if (!(sum > 0.0)) continue;
    const Band one = betweenTails(response, sum);
    if (!all) all = one;
    all = Band{std::min(all->first, one.first), std::max(all->last, one.last)};
  }
  return all;
}

}  // namespace cutis
