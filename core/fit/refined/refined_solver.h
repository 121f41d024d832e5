#pragma once

// The default method: the exact physics at the spectral nodes, maximum a posteriori.
//
// The same objective as MapEstimator, vectorised in single precision. Against it the coordinates
// are within a few hundredths of a posterior standard deviation: the fit stops where another step
// would be lost in the noise. With zero noise (the exact setting) a second pass in double precision
// takes it to full convergence.

#include <memory>

#include "core/fit/fit_options.h"
#include "core/fit/pixel_solver.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

// Preparation (nodes, start polynomial) takes about 0.2 s.
std::unique_ptr<const PixelSolver> makeRefinedSolver(std::shared_ptr<const SkinModel> model,
                                                     const Rig& rig, const FitOptions& options);

}  // namespace cutis
