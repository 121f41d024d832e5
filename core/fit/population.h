#pragma once

// People drawn at random: the population of the error protocol (after the paper's Table 1), uniform
// in a box that spans faces, and people as a prior has them. Deterministic by seed.

#include <cstdint>
#include <vector>

#include "core/skin/profile/parameter_axis.h"
#include "core/skin/profile/prior.h"

namespace cutis {

struct ParameterBox {
  ParameterVector low;
  ParameterVector high;
};

// C_m .01–.25, β_m .2–1, C_hd .005–.1, C_he 0–.05, C_bc 0–.004.
ParameterBox protocolPopulation();

std::vector<ParameterVector> drawPopulation(const ParameterBox& box, int count,
                                            unsigned long long seed);

// Drawn again while outside of the axes' ranges. A prior that hardly knows anyone inside is given
// up on after some tries: then the nearest values inside stand. Precondition: validate(prior)
// passed.
std::vector<ParameterVector> drawFromPrior(const Prior& prior, const ParameterAxes& axes, int count,
                                           std::uint64_t seed);

}  // namespace cutis
