#pragma once

// Photographs of simulated skin through any rig.

#include <cstdint>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/measurements.h"
#include "core/rig/rig.h"
#include "core/simulate/skin_patch.h"
#include "core/skin/chromophore_maps.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

// Each channel is what the model predicts (to about 2e-6), with the constants of each pixel where
// the maps have them (then to about 1e-5), times 1 + proportionalNoise · n with n normal and
// independent between pixels and channels, never negative. Pixels without an estimate show the
// backdrop and are marked masked, all others `solved`: there to be solved. NaN in the maps reads 0
// in its pixel. Deterministic by seed, for any number of threads. The result has the maps' size, in
// float, and its own memory. Errors: a noise that is no standard deviation; memory, disk. About
// 0.15 s for 1024² and nine channels on two cores.
Result<Measurements> photograph(const ChromophoreMaps& maps, const SkinModel& model, const Rig& rig,
                                double proportionalNoise, std::uint64_t seed,
                                const JobContext& context);

inline Result<Measurements> photograph(const SimulatedSkin& skin, const SkinModel& model,
                                       const Rig& rig, double proportionalNoise, std::uint64_t seed,
                                       const JobContext& context) {
  return photograph(skin.maps, model, rig, proportionalNoise, seed, context);
}

}  // namespace cutis
