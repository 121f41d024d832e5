#pragma once

// The refined fit with oxygenation or thickness, or both, found for each pixel beside the five
// parameters: for photographs under many lights (core/skin/profile/free_constants.h).
//
// Maximum a posteriori in double precision, with the prior of core/fit/free/free_prior.h for the
// constants. A pixel begins midway between the prior's mean and what the ordinary refined fit finds
// for it, which bends the parameters to what the constants explain; where that ends in a misfit
// that is no noise, further searches begin at what that fit found and at the prior's mean, and the
// most probable end is kept. Deviations are of the normal approximation.

#include <memory>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/fit_options.h"
#include "core/fit/pixel_solver.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

// Refuses what the channels cannot decide: fewer independent channels than values to find. `place`
// stands in front of the error.
Status checkChannelsDecide(const Rig& rig, const FitOptions& options, const std::string& place);

// Preconditions: something is free, no shading, checkChannelsDecide() passed. Preparation: that of
// FreeResponse::make. Errors: the same. The time per pixel is in resources/manual/fitting.md.
Result<std::unique_ptr<const PixelSolver>> makeFreeSolver(std::shared_ptr<const SkinModel> model,
                                                          const Rig& rig, const FitOptions& options,
                                                          const JobContext& context);

}  // namespace cutis
