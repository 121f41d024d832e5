#pragma once

// Five parameters per pixel, and what became of each pixel.

#include <array>
#include <memory>

#include "core/base/plane.h"
#include "core/skin/parameter.h"

namespace cutis {

struct ChromophoreMaps {
  // Indexed by Parameter, in its unit; 0 where there is no estimate.
  std::array<Plane, kParameterCount> values;
  // PixelState as a number.
  Plane state;

  ChromophoreMaps() = default;
  ChromophoreMaps(int width, int height, PixelFormat format = PixelFormat::float32,
                  const std::shared_ptr<TileStore>& store = nullptr);

  int width() const { return state.width(); }
  int height() const { return state.height(); }
};

}  // namespace cutis
