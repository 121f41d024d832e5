#pragma once

namespace cutis {

// What became of a pixel. The values stand in files (part `state` of maps).
enum class PixelState : int {
  solved = 0,
  masked = 1,         // left out by the mask
  invalid = 2,        // not finite, negative or black in the photographs
  saturated = 3,      // clipped in a photograph
  noConvergence = 4,  // solved as well as the iteration limit allowed
};

}  // namespace cutis
