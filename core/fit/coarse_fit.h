#pragma once

// A first impression of the maps, long before the fit is complete.

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/pixel_solver.h"
#include "core/rig/measurements.h"
#include "core/skin/chromophore_maps.h"

namespace cutis {

// One pixel in each block of this side stands for the block until runFit() replaces it.
inline constexpr int kCoarseBlock = 16;

// Solves the upper left pixel of each block and gives its values to all pixels of the block that
// are there to be solved; blocks whose pixel is not stay empty. maps: of the size of the
// measurements, as runFit() will fill them. About a hundredth of the cost of the fit. Cancelled if
// asked to stop.
Status runCoarseFit(const Measurements& measurements, const PixelSolver& solver,
                    ChromophoreMaps maps, const JobContext& context);

}  // namespace cutis
