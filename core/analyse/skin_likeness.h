#pragma once  // internal to core/analyse

// Which pixels can be skin of the profile: the one place that says so, for reports, for the ranges
// of maps, and for whatever leaves the rest of a picture alone.
//
// For a colour-matching observer under one light (albedo textures) a pixel is like skin if its
// reconstruction, seen by that observer under that light (D65 for the rig `albedo`), differs from
// the measurement by at most ΔE2000 1. For a camera's photographs it is if the root mean square
// over all channels of (measured − modelled) / noise is at most 3. Thread-safe: a pure function.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/analyse/pixel_sample.h"
#include "core/rig/rig.h"

namespace cutis {

struct SkinLikeness {
  std::vector<std::uint8_t> isSkin;  // of each pixel
  std::vector<double> deltaE;        // of each pixel's colour; only of albedo textures
};

// noise: what the fit assumed instead of the rig's own; where that is zero the rig's counts.
// The sample has channels and values.
SkinLikeness judgeSkin(const Rig& rig, const PixelSolver& solver,
                       const std::optional<NoiseModel>& noise, const PixelSample& sample);

}  // namespace cutis
