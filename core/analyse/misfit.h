#pragma once

// How far a pixel is from the model, counted in its noise.
//
// The misfit is the root mean square over the channels of (measured − modelled) / noise. A channel
// without noise says nothing. Double precision; thread-safe: pure functions.

#include <optional>
#include <vector>

#include "core/base/pixel_rows.h"
#include "core/rig/rig.h"

namespace cutis {

// The noise that misfits are counted in: what a fit assumed instead of the rig's, or the rig's;
// where that is none, the usual one.
NoiseModel misfitNoise(const Rig& rig, const std::optional<NoiseModel>& assumed);

// One per pixel; NaN where a channel is. residuals: as PixelSolver::residuals() writes them.
std::vector<double> misfitsOf(const NoiseModel& noise, PixelRows<const float> channels,
                              PixelRows<const float> residuals);

}  // namespace cutis
