#pragma once

// What became of a pixel: one classification from the photograph to the maps.
//
// Planes, and files with them, hold it as a number. These functions are the only way between the
// two. Thread-safe: pure functions.

#include <cstddef>
#include <cstdint>

namespace cutis {

// The values stand in files (part `state` of maps).
enum class PixelState : std::uint8_t {
  solved = 0,         // of a photograph: there to be solved
  masked = 1,         // left out by the mask
  invalid = 2,        // not finite, negative or black in the photographs
  saturated = 3,      // clipped in a photograph
  noConvergence = 4,  // solved as well as the iteration limit allowed
};
inline constexpr std::size_t kPixelStateCount = 5;

constexpr float storedState(PixelState state) {
  return static_cast<float>(state);
}

// Whether a number of a plane stands for a state; NaN does not.
constexpr bool isPixelState(float stored) {
  return stored >= 0.0f && stored < static_cast<float>(kPixelStateCount) &&
         stored == static_cast<float>(static_cast<int>(stored));
}

// A number that stands for none is an invalid pixel.
constexpr PixelState pixelState(float stored) {
  return isPixelState(stored) ? static_cast<PixelState>(static_cast<int>(stored))
                              : PixelState::invalid;
}

// Whether there are parameters.
constexpr bool hasEstimate(PixelState state) {
  return state == PixelState::solved || state == PixelState::noConvergence;
}

}  // namespace cutis
