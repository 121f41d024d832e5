#pragma once

// How the values of maps are spread over what can be skin, for ranges in which a map can be read:
// hair, eyes and background would otherwise take most of the scale. Thread-safe: pure functions.

#include <array>
#include <optional>
#include <vector>

#include "core/analyse/skin_likeness.h"
#include "core/skin/profile/parameter_axis.h"

namespace cutis {

// The values of each parameter in ascending order, in its unit.
struct SkinValues {
  std::array<std::vector<float>, kParameterCount> sorted;
  // ΔE2000 of the reconstruction, over the pixels that can be skin; only of albedo textures.
  std::optional<double> medianDeltaE;
};

// The values of pixels that can be skin of the profile and whose concentrations are below the ends
// of their ranges: where one is at its end, no skin explains the pixel. Where that leaves fewer
// than one pixel in a hundred, all pixels count.
SkinValues skinValuesOf(const JudgedPixels& pixels, const ParameterAxes& axes);

struct ValueRange {
  double minimum = 0.0;
  double maximum = 1.0;
};

// From the 1st to the 99th of a hundred values; where these are one, from 0 to it. None without
// values.
std::optional<ValueRange> typicalRange(const std::vector<float>& sorted);

}  // namespace cutis
