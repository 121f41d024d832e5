#pragma once

// MapEstimator as a pixel solver.

#include <memory>

#include "core/fit/fit_options.h"
#include "core/fit/pixel_solver.h"
#include "core/skin/skin_model.h"

namespace cutis {

std::unique_ptr<const PixelSolver> makeReferenceSolver(std::shared_ptr<const SkinModel> model, const Rig& rig,
                                                       const FitOptions& options);

}  // namespace cutis
