#include "core/rig/measurements.h"

#include <algorithm>
#include <cmath>

namespace cutis {

PixelState classify(std::span<const float> channels, float mask, bool clipped) {
  if (!(mask > 0.0f)) return PixelState::masked;
  float largest = 0.0f;
  for (const float value : channels) {
    if (!std::isfinite(value) || value < 0.0f) return PixelState::invalid;
    largest = std::max(largest, value);
  }
  if (largest <= 0.0f) return PixelState::invalid;
  return clipped ? PixelState::saturated : PixelState::solved;
}

}  // namespace cutis
