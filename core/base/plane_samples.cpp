#include "core/base/plane_samples.h"

#include <vector>

namespace cutis {

std::size_t sampleCount(const Rect& rect, int step) {
  const auto steps = [&](int side) { return static_cast<std::size_t>((side + step - 1) / step); };
  return steps(rect.width()) * steps(rect.height());
}

Status loadSampled(const Plane& plane, const Rect& rect, int step, std::span<float> out) {
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

}  // namespace cutis
