#pragma once

// What a fit found of the free constants, and how much of it the channels determined.
//
// Looked at is a regular sample of the pixels with an estimate, at most about 16,000 and all of a
// small picture. Deterministic; a fraction of a second.

#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/pixel_solver.h"
#include "core/rig/measurements.h"
#include "core/skin/chromophore_maps.h"
#include "core/skin/profile/profile.h"

namespace cutis {

struct ConstantSummary {
  SkinConstant constant = kOxygenation;
  double mean = 0.0, low = 0.0, high = 0.0;  // 5 and 95 of 100 pixels are below
  double openShare = 0.0;  // posterior over prior deviation, median: 0 is known, 1 is assumed
};

// Above this what was found is mostly what was assumed.
inline constexpr double kMostlyAssumed = 0.7;

// One for each constant of the maps, none if there are no pixels with an estimate. maps: what the
// solver found for these measurements, with its constants.
Result<std::vector<ConstantSummary>> summariseConstants(const Measurements& measurements,
                                                        const ChromophoreMaps& maps,
                                                        const PixelSolver& solver,
                                                        const Profile& profile,
                                                        const JobContext& context);

}  // namespace cutis
