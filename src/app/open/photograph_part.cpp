#include "src/app/open/photograph_part.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cutis {

Result<PictureBuffer> photographPart(const Source& source, const Rect& rect, int step, int light) {
  PictureBuffer part;
  part.width = (rect.width() + step - 1) / step;
  part.height = (rect.height() + step - 1) / step;
  const std::size_t width = static_cast<std::size_t>(part.width);
  const std::size_t pixels = width * static_cast<std::size_t>(part.height);
  part.channels.assign(3, std::vector<float>(pixels));
  part.present.assign(pixels, true);

  // Row by row, so that a coarse view of a large picture needs no more memory than it shows.
  const Eigen::Matrix3f matrix = source.toRec709.cast<float>();
  const std::size_t first = 3 * static_cast<std::size_t>(light);
  std::array<std::vector<float>, 3> row;
  for (std::vector<float>& channel : row) {
    channel.resize(static_cast<std::size_t>(rect.width()));
  }
  for (std::size_t y = 0; y < static_cast<std::size_t>(part.height); ++y) {
    const int line = rect.y0 + static_cast<int>(y) * step;
    for (std::size_t c = 0; c < 3; ++c) {
      const Plane& channel = source.measurements.channels[first + c];
      CUTIS_CHECK(channel.load({rect.x0, line, rect.x1, line + 1}, row[c]));
    }
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t from = x * static_cast<std::size_t>(step);
      const Eigen::Vector3f rgb =
          matrix * Eigen::Vector3f(row[0][from], row[1][from], row[2][from]);
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = rgb[static_cast<Eigen::Index>(c)];
        part.channels[c][y * width + x] = std::isfinite(value) ? value : 0.0f;
      }
    }
  }
  return part;
}

}  // namespace cutis
