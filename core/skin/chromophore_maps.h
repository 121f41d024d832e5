#pragma once

// Five parameters per pixel, constants of the profile that were found for each pixel beside them,
// and what became of each pixel.

#include <array>
#include <memory>
#include <vector>

#include "core/base/plane.h"
#include "core/skin/profile/parameter.h"
#include "core/skin/profile/per_pixel.h"

namespace cutis {

struct ChromophoreMaps {
  // Indexed by Parameter, in its unit; 0 where there is no estimate.
  std::array<Plane, kParameterCount> values;
  // storedState() of each pixel.
  Plane state;
  // Indexed by SkinConstant, 0 where there is no estimate; empty: the profile's own holds.
  std::array<Plane, kConstantCount> constants;
  // Coefficients of what the profile's model leaves over, 0 where there is no estimate; and of
  // which of its discrepancies. Empty: of none. Halves: they tell little beyond three digits.
  std::vector<Plane> coefficients;
  SurfaceLight surface = SurfaceLight::included;

  ChromophoreMaps() = default;
  ChromophoreMaps(int width, int height, PixelFormat format = PixelFormat::float32,
                  const std::shared_ptr<TileStore>& store = nullptr,
                  const FreeConstants& free = {});

  // The constants of which there is a plane.
  FreeConstants free() const {
    return {!constants[kOxygenation].empty(), !constants[kThickness].empty()};
  }
  // What pixels bring along beside the parameters.
  PerPixel perPixel() const;
  void addCoefficients(SurfaceLight of, int count, const std::shared_ptr<TileStore>& store);
  // The planes of the parameters, then of the constants that are free, then of the coefficients:
  // handles.
  std::vector<Plane> planes() const;

  int width() const { return state.width(); }
  int height() const { return state.height(); }
};

// Whether the profile knows the discrepancy whose coefficients the maps hold, with as many of them;
// `place` names the maps in the error.
Status checkCoefficients(const ChromophoreMaps& maps, const Profile& profile,
                         const std::string& place);

}  // namespace cutis
