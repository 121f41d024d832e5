#pragma once

// Vectorised posterior spread, for core/fit/refined_solver.cpp. Plain data, see
// core/skin/node_constants.h.

#include "core/fit/refined_kernel.h"

namespace cutis {

struct PosteriorBatch {
  std::size_t count;
  std::size_t stride;
  const float* channels;     // [channel][stride]
  const float* coordinates;  // [coordinate][stride]
  float* deviations;         // out, of the coordinates: [coordinate][stride]; 0 for fixed ones
};

// Standard deviations from the inverse of the full 5 × 5 normal matrix at the coordinates.
void runPosteriorKernel(const RefinedProblem<float>& problem, const PosteriorBatch& batch);

}  // namespace cutis
