#pragma once

// Which pixels can be skin of the profile: the one place that says so, for reports, for the ranges
// of maps, and for whatever leaves the rest of a picture alone.
//
// For a colour-matching observer under one light (albedo textures) a pixel is like skin if its
// reconstruction, seen by that observer under that light (D65 for the rig `albedo`), differs from
// the measurement by at most ΔE2000 1. For a camera's photographs it is if the root mean square
// over all channels of (measured − modelled) / noise is at most 3.
//
// Of a whole picture a regular sample of the pixels with an estimate is looked at, at most about
// 65,000 and all of a small picture: some milliseconds. Deterministic. Thread-safe: pure functions.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/analyse/pixel_sample.h"
#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/pixel_solver.h"
#include "core/rig/measurements.h"
#include "core/skin/chromophore_maps.h"

namespace cutis {

struct JudgedPixels {
  PixelBuffer<float> values;         // as in core/fit/pixel_solver.h
  std::vector<std::uint8_t> isSkin;  // of each pixel
  std::vector<double> deltaE;        // of each pixel's colour; only of albedo textures

  std::size_t count() const { return isSkin.size(); }
};

// noise, here and below: what the fit assumed instead of the rig's own; where that is zero the
// rig's counts.
JudgedPixels judgePixels(PixelSample sample, const Rig& rig, const PixelSolver& solver,
                         const std::optional<NoiseModel>& noise);
Result<JudgedPixels> judgePixels(const Measurements& measurements, const ChromophoreMaps& maps,
                                 const PixelSolver& solver, const std::optional<NoiseModel>& noise,
                                 const JobContext& context);
// For maps whose measurements are not at hand: nothing speaks against any pixel.
Result<JudgedPixels> judgePixels(const ChromophoreMaps& maps, const JobContext& context);

}  // namespace cutis
