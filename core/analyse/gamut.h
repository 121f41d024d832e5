#pragma once

// How much of a picture the skin model can be: pixels whose colour or channels no skin of the
// profile has.
//
// Looked at is a regular sample of the pixels with an estimate, at most about 65,000 and all of a
// small picture. core/analyse/skin_likeness.h says when a pixel is outside. Deterministic; some
// milliseconds.

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
