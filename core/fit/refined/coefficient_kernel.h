#pragma once  // internal to core/fit/refined

// Vectorised coefficients of the discrepancy, for core/fit/refined/refined_solver.cpp. Plain data,
// see core/skin/layers/node_constants.h.

#include "core/fit/refined/refined_kernel.h"
#include "core/skin/profile/discrepancy_size.h"

namespace cutis {

// Coefficients at an estimate, see ChannelDiscrepancy.
struct CoefficientProblem {
  std::size_t count = 0;
  float offset[kMaximumCoefficients] = {};
  float slope[kMaximumCoefficients][kParameterCount] = {};
  float gain[kMaximumCoefficients][kMaximumFitChannels] = {};
};

// The most probable coefficients at the coordinates, a row each, but no further from 0 than
// kMostCoefficientNorm. Precondition: the problem has a discrepancy. About 30 ns a pixel and core.
void runCoefficientKernel(const RefinedProblem<float>& problem, const CoefficientProblem& line,
                          PixelRows<const float> channels, PixelRows<const float> coordinates,
                          PixelRows<float> coefficients);

}  // namespace cutis
