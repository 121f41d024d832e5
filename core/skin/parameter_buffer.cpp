#include "core/skin/parameter_buffer.h"

#include <cstddef>

#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

// Loads whole rows, a band at a time, and keeps every step-th.
Status loadEvery(const Plane& plane, const Rect& rect, int step, std::vector<float>& out) {
  if (step == 1) {
    out.resize(rect.pixelCount());
    return plane.load(rect, out);
  }
  std::vector<float> row(static_cast<std::size_t>(rect.width()));
  out.clear();
  for (int y = rect.y0; y < rect.y1; y += step) {
    CUTIS_CHECK(plane.load({rect.x0, y, rect.x1, y + 1}, row));
    for (std::size_t x = 0; x < row.size(); x += static_cast<std::size_t>(step)) {
      out.push_back(row[x]);
    }
  }
  return {};
}

bool hasEstimate(float state) {
  const auto pixel = static_cast<PixelState>(static_cast<int>(state));
  return pixel == PixelState::solved || pixel == PixelState::noConvergence;
}

}  // namespace

ParameterBatch<float> ParameterBuffer::batch() const {
  ParameterBatch<float> batch;
  for (std::size_t k = 0; k < values.size(); ++k)
    batch.values[k] = values[k].data();
  batch.count = count();
  for (std::size_t k = 0; k < constants.size(); ++k) {
    if (!constants[k].empty()) batch.constants[k] = constants[k].data();
  }
  return batch;
}

Result<ParameterBuffer> loadParameters(const ChromophoreMaps& maps, const Rect& rect, int step) {
  ParameterBuffer buffer;
  for (std::size_t k = 0; k < buffer.values.size(); ++k) {
    CUTIS_CHECK(loadEvery(maps.values[k], rect, step, buffer.values[k]));
  }
  for (std::size_t k = 0; k < buffer.constants.size(); ++k) {
    if (maps.constants[k].empty()) continue;
    CUTIS_CHECK(loadEvery(maps.constants[k], rect, step, buffer.constants[k]));
  }
  std::vector<float> states;
  CUTIS_CHECK(loadEvery(maps.state, rect, step, states));
  buffer.present.reserve(states.size());
  for (const float state : states)
    buffer.present.push_back(hasEstimate(state));
  return buffer;
}

Status storeParameters(const ParameterBuffer& buffer, const Rect& rect, ChromophoreMaps& maps) {
  for (std::size_t k = 0; k < buffer.values.size(); ++k) {
    CUTIS_CHECK(maps.values[k].store(rect, buffer.values[k]));
  }
  return {};
}

}  // namespace cutis
