#pragma once

// A regular sample of the pixels of a picture that can be solved, and how well a model explains
// them.

#include <cstddef>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/pixel_solver.h"
#include "core/rig/measurements.h"
#include "core/skin/chromophore_maps.h"

namespace cutis {

struct PixelSample {
  std::size_t count = 0;
  PixelBuffer<float> channels, values;  // as in core/fit/pixel_solver.h
};

// Every n-th pixel of every n-th row, the least n that takes at most `most` pixels; only those that
// can be solved. Values are those of `maps`; without maps there are none.
Result<PixelSample> samplePixels(const Measurements& measurements, const ChromophoreMaps* maps,
                                 std::size_t most, const JobContext& context);

// The same of maps alone: channels are empty.
Result<PixelSample> sampleMaps(const ChromophoreMaps& maps, std::size_t most,
                               const JobContext& context);

// ΔE2000 between each pixel's measurement and its model, for a rig with an observer and one light.
std::vector<double> reconstructionDeltaE(const Rig& rig, const PixelSolver& solver,
                                         const PixelSample& sample);

// Whether colours of the rig's pixels mean something: an observer under one light.
bool seesColors(const Rig& rig);

// Reconstructions at most this far away count as the same colour.
inline constexpr double kSameColorDeltaE = 1.0;

}  // namespace cutis
