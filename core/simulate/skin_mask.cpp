#include "core/simulate/skin_mask.h"

#include <cstddef>
#include <vector>

#include "core/base/parallel.h"
#include "core/skin/pixel_state.h"

namespace cutis {

Result<Plane> skinMask(const Measurements& photographs, const JobContext& context) {
  const Plane& state = photographs.state;
  Plane mask(state.width(), state.height(), PixelFormat::half);
  CUTIS_CHECK(parallelFor(static_cast<std::size_t>(state.tileCount()), context,
                          [&](std::size_t i) -> Status {
                            const Rect rect = state.tileRect(static_cast<int>(i));
                            std::vector<float> values(rect.pixelCount());
                            CUTIS_CHECK(state.load(rect, values));
                            for (float& value : values) {
                              const bool isThere = value == static_cast<float>(PixelState::solved);
                              value = isThere ? 1.0f : 0.0f;
                            }
                            return mask.store(rect, values);
                          }));
  return mask;
}

}  // namespace cutis
