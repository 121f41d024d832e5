#include "core/rig/measurements.h"

#include <algorithm>
#include <cmath>

namespace cutis {

Status Measurements::loadChannel(std::size_t channel, const Rect& rect,
                                 std::span<float> values) const {
  CUTIS_CHECK(channels[channel].load(rect, values));
  if (exposure == 1.0) return {};
  const auto factor = static_cast<float>(exposure);
  for (float& value : values)
    value *= factor;
  return {};
}

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
