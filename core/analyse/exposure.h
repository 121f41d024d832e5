#pragma once

// The exposure of an albedo texture: textures are often painted or normalised brighter or darker
// than skin reflects, and then no skin of the profile has their colours.

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/pixel_solver.h"
#include "core/rig/measurements.h"

namespace cutis {

struct ExposureChoice {
  double exposure = 1.0;
  double inside = 0.0;  // share of the pixels looked at whose reconstruction is within ΔE2000 1
};

// Among scales from an eighth to twice, six to an octave, the one that puts most of a few thousand
// regularly sampled pixels inside the profile's gamut; but 1, where no other brings at least five
// pixels in a hundred more there. Scales that differ by less than one pixel in a hundred count as
// equal: of these, the one nearest to 1. Without pixels to solve it is 1.
// The measurements' own exposure does not count. Deterministic; about a second for the exact fit.
Result<ExposureChoice> chooseExposure(const Measurements& measurements, const PixelSolver& solver,
                                      const JobContext& context);

}  // namespace cutis
