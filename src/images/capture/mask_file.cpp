#include "src/images/capture/mask_file.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/parallel.h"
#include "src/images/codec/image_reader.h"

namespace cutis {
namespace {

Status clampToMask(Plane& plane, const JobContext& context) {
  const auto count = static_cast<std::size_t>(plane.tileCount());
  return parallelFor(count, {context.stop, {}, {}}, [&](std::size_t i) -> Status {
    const Rect rect = plane.tileRect(static_cast<int>(i));
    std::vector<float> values(rect.pixelCount());
    CUTIS_CHECK(plane.load(rect, values));
    for (float& value : values)
      value = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
    return plane.store(rect, values);
  });
}

std::string maskSizeText(int width, int height) {
  return std::to_string(width) + " × " + std::to_string(height);
}

}  // namespace

Result<Plane> readMask(const std::filesystem::path& path, int width, int height,
                       const std::string& subject, const std::shared_ptr<TileStore>& store,
                       const JobContext& context) {
  CUTIS_TRY(reader, ImageReader::open(path, context));
  CUTIS_TRY(part, reader.part(0));
  if (part.width() != width || part.height() != height) {
    return inputError(path.string(), "the mask is " + maskSizeText(part.width(), part.height()) +
                                         " pixels but " + subject + " is " +
                                         maskSizeText(width, height) + "; make them the same size");
  }
  constexpr std::array<int, 1> first = {0};
  CUTIS_TRY(planes, reader.read(part, first, PixelFormat::float32, store, context));
  CUTIS_CHECK(clampToMask(planes.front(), context));
  return planes.front();
}

}  // namespace cutis
