#include "src/app/export/picture_encoding.h"

#include "core/base/choice_place.h"
#include "core/base/parallel.h"
#include "src/color/color_space.h"

namespace cutis {
namespace {

Status encodeTile(const std::vector<Plane>& linear, const ColorConverter& convert, const Rect& rect,
                  std::vector<Plane>& encoded) {
  const std::size_t pixels = rect.pixelCount();
  std::vector<float> plane(pixels), rgb(3 * pixels);
  for (std::size_t c = 0; c < 3; ++c) {
    if (c < linear.size()) CUTIS_CHECK(linear[c].load(rect, plane));
    for (std::size_t p = 0; p < pixels; ++p)
      rgb[3 * p + c] = plane[p];
  }
  CUTIS_CHECK(convert(rgb));
  for (std::size_t c = 0; c < encoded.size(); ++c) {
    for (std::size_t p = 0; p < pixels; ++p)
      plane[p] = rgb[3 * p + c];
    CUTIS_CHECK(encoded[c].store(rect, plane));
  }
  return {};
}

}  // namespace

Result<std::vector<Plane>> encodePicture(const std::vector<Plane>& linear, const ColorSpace& space,
                                         const std::shared_ptr<TileStore>& store,
                                         const JobContext& context) {
  const ColorConverter& convert = space.fromLinearRec709;
  const Plane& size = linear.front();
  std::vector<Plane> encoded;
  for (std::size_t c = 0; c < linear.size(); ++c) {
    encoded.emplace_back(size.width(), size.height(), PixelFormat::float32, store);
  }
  CUTIS_CHECK(parallelFor(static_cast<std::size_t>(size.tileCount()), context, [&](std::size_t i) {
    return encodeTile(linear, convert, size.tileRect(static_cast<int>(i)), encoded);
  }));
  return encoded;
}

}  // namespace cutis
