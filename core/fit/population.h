#pragma once

// The population of the error protocol (after the paper's Table 1): parameters drawn uniformly from
// a box that spans faces.

#include <vector>

#include "core/skin/parameter_axis.h"

namespace cutis {

struct ParameterBox {
  ParameterVector low;
  ParameterVector high;
};

// C_m .01–.25, β_m .2–1, C_hd .005–.1, C_he 0–.05, C_bc 0–.004.
ParameterBox protocolPopulation();

// Deterministic by seed.
std::vector<ParameterVector> drawPopulation(const ParameterBox& box, int count,
                                            unsigned long long seed);

}  // namespace cutis
