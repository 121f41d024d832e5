#pragma once

// Five parameters per pixel, constants of the profile that were found for each pixel beside them,
// and what became of each pixel.

#include <array>
#include <memory>
#include <vector>

#include "core/base/plane.h"
#include "core/skin/profile/free_constants.h"
#include "core/skin/profile/parameter.h"

namespace cutis {

struct ChromophoreMaps {
  // Indexed by Parameter, in its unit; 0 where there is no estimate.
  std::array<Plane, kParameterCount> values;
  // storedState() of each pixel.
  Plane state;
  // Indexed by SkinConstant, 0 where there is no estimate; empty: the profile's own holds.
  std::array<Plane, kConstantCount> constants;

  ChromophoreMaps() = default;
  ChromophoreMaps(int width, int height, PixelFormat format = PixelFormat::float32,
                  const std::shared_ptr<TileStore>& store = nullptr,
                  const FreeConstants& free = {});

  // The constants of which there is a plane.
  FreeConstants free() const {
    return {!constants[kOxygenation].empty(), !constants[kThickness].empty()};
  }
  // The planes of the parameters, then of the constants that are free: handles.
  std::vector<Plane> planes() const;

  int width() const { return state.width(); }
  int height() const { return state.height(); }
};

}  // namespace cutis
