#pragma once  // internal to core/fit/refined

// Vectorised posterior spread, for core/fit/refined/refined_solver.cpp. Plain data, see
// core/skin/layers/node_constants.h.

#include "core/fit/refined/refined_kernel.h"

namespace cutis {

struct PosteriorBatch {
  std::size_t count;
  std::size_t stride;
  const float* channels;     // [channel][stride]
  const float* coordinates;  // [coordinate][stride]
  float* deviations;         // out, of the coordinates: [coordinate][stride]; 0 for fixed ones
};

// How far the truth may lie from the estimate: root mean square distance under the posterior, each
// coordinate by itself while the others follow. Near the estimate the posterior is normal, with the
// inverse of the full 5 × 5 normal matrix; away from it, its own shape along the coordinate and the
// box count (core/fit/refined/posterior_spread-inl.h), since a deviation of the normal curve alone
// is far too small where little is known. About 0.5 µs a pixel and core.
void runPosteriorKernel(const RefinedProblem<float>& problem, const PosteriorBatch& batch);

}  // namespace cutis
