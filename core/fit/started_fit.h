#pragma once

// The refined fit in single precision, each pixel from a start of its own (core/fit/
// start_polynomial.h). Thread-safe: const after construction.

#include "core/fit/refined_problem.h"

namespace cutis {

class StartedFit {
 public:
  // Trains the start, about 60 ms.
  StartedFit(const SkinModel& model, const SpectralNodes& nodes, const Prior& prior,
             const NoiseModel& noise, const FitOptions& options);
  StartedFit(const StartedFit&) = delete;
  StartedFit& operator=(const StartedFit&) = delete;

  // What a batch holds, as runRefinedKernel(): coordinates come out.
  void solve(const RefinedBatch<float>& batch) const { runRefinedKernel(problem(), batch); }
  const RefinedProblem<float>& problem() const { return data_.problem(); }

 private:
  RefinedProblemData<float> data_;
  StartPolynomial start_ = {};
};

}  // namespace cutis
