#include "core/fit/shading.h"

#include <cstddef>

namespace cutis {

float shadingFactor(const ShadingModel& model, PixelRows<const float> measured,
                    PixelRows<const float> modelled) {
  const double precision = 1.0 / (model.deviation * model.deviation);
  double above = precision, below = precision;
  for (std::size_t k = 0; k < measured.rowCount; ++k) {
    const double y = double{measured.at(k, 0)}, f = double{modelled.at(k, 0)};
    const double variance = model.noise.variance(y);
    above += y * f / variance;
    below += f * f / variance;
  }
  return static_cast<float>(above / below);
}

}  // namespace cutis
