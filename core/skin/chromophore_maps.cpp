#include "core/skin/chromophore_maps.h"

namespace cutis {

ChromophoreMaps::ChromophoreMaps(int width, int height, PixelFormat format,
                                 const std::shared_ptr<TileStore>& store, const FreeConstants& free)
    : state(width, height, PixelFormat::half, store) {
  for (Plane& plane : values)
    plane = Plane(width, height, format, store);
  for (const SkinConstant constant : kSkinConstants) {
    if (free.has(constant)) constants[constant] = Plane(width, height, format, store);
  }
}

std::vector<Plane> ChromophoreMaps::planes() const {
  std::vector<Plane> all(values.begin(), values.end());
  for (const Plane& plane : constants) {
    if (!plane.empty()) all.push_back(plane);
  }
  return all;
}

}  // namespace cutis
