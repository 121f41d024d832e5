#pragma once

// How much of a picture the skin model can be: pixels whose colour or channels no skin of the
// profile has. Thread-safe: a pure function.

#include <optional>

#include "core/analyse/skin_likeness.h"

namespace cutis {

struct GamutStatistics {
  double outsideShare = 0.0;  // of the pixels looked at
  // The median over the pixels inside; only of albedo textures, and only if there are any.
  std::optional<double> medianDeltaE;
};

GamutStatistics gamutOf(const JudgedPixels& pixels);

}  // namespace cutis
