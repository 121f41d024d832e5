#pragma once

// The refined fit in single precision, each pixel from a start of its own
// (core/fit/refined/start_polynomial.h). Thread-safe: const after construction.

#include "core/fit/refined/refined_problem.h"

namespace cutis {

class FastPass {
 public:
  // Trains the start, about 60 ms.
  FastPass(const SkinModel& model, const SpectralNodes& nodes, const Prior& prior,
           const NoiseModel& noise, const FitOptions& options,
           const ChannelDiscrepancy& discrepancy = {});
  FastPass(const FastPass&) = delete;
  FastPass& operator=(const FastPass&) = delete;

  // As runRefinedKernel(): coordinates come out.
  void solve(const RefinedPixels<float>& pixels) const { runRefinedKernel(problem(), pixels); }
  const RefinedProblem<float>& problem() const { return data_.problem(); }

 private:
  RefinedProblemData<float> data_;
  StartPolynomial start_ = {};
};

}  // namespace cutis
