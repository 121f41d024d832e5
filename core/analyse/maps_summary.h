#pragma once

// What is in maps: pixels by their state, and the spread of a value over those with an estimate.
//
// Every pixel is looked at; a value takes 4 bytes a pixel meanwhile. Errors: memory, disk.

#include <array>
#include <cstddef>
#include <optional>

#include "core/base/plane.h"
#include "core/base/result.h"
#include "core/skin/pixel_state.h"

namespace cutis {

// By PixelState.
using StateCounts = std::array<std::size_t, kPixelStateCount>;

// state: as in ChromophoreMaps and Measurements. Values that are no state are passed over.
Result<StateCounts> countStates(const Plane& state);

struct ValueSpread {
  float low = 0.0f, median = 0.0f, high = 0.0f;  // 5, 50 and 95 of 100 pixels are below
};

// Over pixels that are solved or without convergence; nothing if there are none. values: of the
// state's size, not NaN there.
Result<std::optional<ValueSpread>> spreadOf(const Plane& values, const Plane& state);

}  // namespace cutis
