#include "core/analyse/misfit.h"

#include <cmath>
#include <cstddef>

namespace cutis {

NoiseModel misfitNoise(const Rig& rig, const std::optional<NoiseModel>& assumed) {
  const NoiseModel noise = assumed.value_or(rig.noise);
  if (!noise.isExact()) return noise;
  return rig.noise.isExact() ? NoiseModel{} : rig.noise;
}

std::vector<double> misfitsOf(const NoiseModel& noise, PixelRows<const float> channels,
                              PixelRows<const float> residuals) {
  std::vector<double> misfits(channels.count);
  for (std::size_t i = 0; i < channels.count; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < channels.rowCount; ++k) {
      const double deviation = std::sqrt(noise.variance(double{channels.at(k, i)}));
      if (!(deviation <= 0.0)) sum += std::pow(double{residuals.at(k, i)} / deviation, 2);
    }
    misfits[i] = std::sqrt(sum / static_cast<double>(channels.rowCount));
  }
  return misfits;
}

}  // namespace cutis
