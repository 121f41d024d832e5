#include "core/fit/shading.h"

#include <cstddef>

namespace cutis {

float shadingFactor(const ShadingModel& model, const float* measured, const float* modelled,
                    int channelCount, std::size_t stride) {
  const double precision = 1.0 / (model.deviation * model.deviation);
  double above = precision, below = precision;
  for (std::size_t k = 0; k < static_cast<std::size_t>(channelCount); ++k) {
    const double y = double{measured[k * stride]}, f = double{modelled[k * stride]};
    const double variance = model.noise.variance(y);
    above += y * f / variance;
    below += f * f / variance;
  }
  return static_cast<float>(above / below);
}

}  // namespace cutis
