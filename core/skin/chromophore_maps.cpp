#include "core/skin/chromophore_maps.h"

namespace cutis {

ChromophoreMaps::ChromophoreMaps(int width, int height, PixelFormat format,
                                 const std::shared_ptr<TileStore>& store)
    : state(width, height, PixelFormat::half, store) {
  for (Plane& plane : values) plane = Plane(width, height, format, store);
}

}  // namespace cutis
