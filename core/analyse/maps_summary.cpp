#include "core/analyse/maps_summary.h"

#include <vector>

#include "core/maths/quantile.h"
#include "core/skin/pixel_state.h"

namespace cutis {

Result<StateCounts> countStates(const Plane& state) {
  StateCounts counts = {};
  for (int t = 0; t < state.tileCount(); ++t) {
    const Rect rect = state.tileRect(t);
    std::vector<float> states(rect.pixelCount());
    CUTIS_CHECK(state.load(rect, states));
    for (const float value : states) {
      const auto s = static_cast<std::size_t>(value);
      if (s < counts.size()) ++counts[s];
    }
  }
  return counts;
}

Result<std::optional<ValueSpread>> spreadOf(const Plane& values, const Plane& state) {
  std::vector<float> estimates;
  for (int t = 0; t < state.tileCount(); ++t) {
    const Rect rect = state.tileRect(t);
    std::vector<float> states(rect.pixelCount()), pixels(rect.pixelCount());
    CUTIS_CHECK(state.load(rect, states));
    CUTIS_CHECK(values.load(rect, pixels));
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (hasEstimate(pixelState(states[i]))) estimates.push_back(pixels[i]);
    }
  }
  if (estimates.empty()) return std::optional<ValueSpread>();
  ValueSpread spread;
  spread.median = quantileOf(estimates, 0.5);
  spread.low = quantileOf(estimates, 0.05);
  spread.high = quantileOf(estimates, 0.95);
  return std::optional(spread);
}

}  // namespace cutis
