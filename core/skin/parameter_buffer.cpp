#include "core/skin/parameter_buffer.h"

#include <cstddef>

#include "core/base/plane_samples.h"
#include "core/skin/pixel_state.h"

namespace cutis {
Result<ParameterBuffer> loadParameters(const ChromophoreMaps& maps, const Rect& rect, int step) {
  const std::vector<Plane> planes = maps.planes();
  ParameterBuffer buffer;
  buffer.values = PixelBuffer<float>(planes.size(), sampleCount(rect, step));
  for (std::size_t k = 0; k < planes.size(); ++k) {
    CUTIS_CHECK(loadSampled(planes[k], rect, step, buffer.values[k]));
  }
  std::vector<float> states(sampleCount(rect, step));
  CUTIS_CHECK(loadSampled(maps.state, rect, step, states));
  buffer.present.reserve(states.size());
  for (const float state : states)
    buffer.present.push_back(hasEstimate(pixelState(state)));
  return buffer;
}

Status storeParameters(const ParameterBuffer& buffer, const Rect& rect, ChromophoreMaps& maps) {
  for (std::size_t k = 0; k < maps.values.size(); ++k) {
    CUTIS_CHECK(maps.values[k].store(rect, buffer.values[k]));
  }
  return {};
}

}  // namespace cutis
