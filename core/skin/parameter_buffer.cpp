#include "core/skin/parameter_buffer.h"

#include <cstddef>
#include <span>

#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

std::size_t countOf(const Rect& rect, int step) {
  const auto steps = [&](int side) { return static_cast<std::size_t>((side + step - 1) / step); };
  return steps(rect.width()) * steps(rect.height());
}

// Loads whole rows, a band at a time, and keeps every step-th. out: countOf(rect, step) pixels.
Status loadEvery(const Plane& plane, const Rect& rect, int step, std::span<float> out) {
  if (step == 1) return plane.load(rect, out);
  std::vector<float> row(static_cast<std::size_t>(rect.width()));
  std::size_t next = 0;
  for (int y = rect.y0; y < rect.y1; y += step) {
    CUTIS_CHECK(plane.load({rect.x0, y, rect.x1, y + 1}, row));
    for (std::size_t x = 0; x < row.size(); x += static_cast<std::size_t>(step))
      out[next++] = row[x];
  }
  return {};
}

}  // namespace

Result<ParameterBuffer> loadParameters(const ChromophoreMaps& maps, const Rect& rect, int step) {
  const std::vector<Plane> planes = maps.planes();
  ParameterBuffer buffer;
  buffer.values = PixelBuffer<float>(planes.size(), countOf(rect, step));
  for (std::size_t k = 0; k < planes.size(); ++k) {
    CUTIS_CHECK(loadEvery(planes[k], rect, step, buffer.values[k]));
  }
  std::vector<float> states(countOf(rect, step));
  CUTIS_CHECK(loadEvery(maps.state, rect, step, states));
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
