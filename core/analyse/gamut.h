#pragma once

// How much of a picture the skin model can be: pixels whose colour or channels no skin of the
// profile has.
//
// Looked at is a regular sample of the pixels with an estimate, at most about 65,000 and all of a
// small picture. For a colour-matching observer under one light (albedo textures) a pixel is
// outside if its reconstruction, seen by that observer under that light (D65 for the rig `albedo`),
// differs from the measurement by more than ΔE2000 1. For a camera's photographs it is outside if
// the root mean square over all channels of (measured − modelled) / noise is above 3, with the
// noise the fit assumed, or the rig's if that was zero. Deterministic; some milliseconds.

#include <optional>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/pixel_solver.h"
#include "core/rig/measurements.h"
#include "core/skin/chromophore_maps.h"

namespace cutis {

struct GamutStatistics {
  double outsideShare = 0.0;  // of the pixels looked at
  // The median over the pixels inside; only of albedo textures, and only if there are any.
  std::optional<double> medianDeltaE;
};

// `noise`: what the fit assumed instead of the rig's own.
Result<GamutStatistics> measureGamut(const Measurements& measurements, const ChromophoreMaps& maps,
                                     const PixelSolver& solver,
                                     const std::optional<NoiseModel>& noise,
                                     const JobContext& context);

}  // namespace cutis
