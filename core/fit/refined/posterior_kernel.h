#pragma once  // internal to core/fit/refined

// Vectorised posterior spread, for core/fit/refined/refined_solver.cpp. Plain data, see
// core/skin/layers/node_constants.h.

#include "core/fit/refined/refined_kernel.h"

namespace cutis {

// How far the truth may lie from the estimate: root mean square distance under the posterior, each
// coordinate by itself while the others follow. Near the estimate the posterior is normal, with the
// inverse of the full 5 × 5 normal matrix; away from it, its own shape along the coordinate and the
// box count (core/fit/refined/posterior_spread-inl.h), since a deviation of the normal curve alone
// is far too small where little is known. deviations: a row per coordinate, 0 for fixed ones. About
// 0.5 µs a pixel and core.
void runPosteriorKernel(const RefinedProblem<float>& problem, PixelRows<const float> channels,
                        PixelRows<const float> coordinates, PixelRows<float> deviations);

}  // namespace cutis
