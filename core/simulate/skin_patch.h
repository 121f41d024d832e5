#pragma once

// A procedural patch of skin: maps of all five parameters, known exactly because they are made.

#include <cstdint>
#include <memory>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"
#include "core/simulate/paint/skin_recipe.h"
#include "core/skin/chromophore_maps.h"
#include "core/skin/profile/parameter_axis.h"

namespace cutis {

inline constexpr int kLargestPatch = 8192;

struct SimulatedSkin {
  ChromophoreMaps maps;  // masked in the background, solved elsewhere
  Plane mask;            // 1 skin, 0 background
};

// Width and height from 1 to kLargestPatch, in pixels; results are clamped to the axes. Maps are
// float. A pixel is a function of its coordinates, the size, recipe and seed: the same bits for any
// number of threads. Another seed gives other freckles, pores, hairs, vessels and noise; lips,
// moles and areas stay in their places. Without a store the planes live in memory. Errors: a size
// or recipe out of range; memory, disk (TileStore). About 0.1 s for 1024² on two cores.
Result<SimulatedSkin> simulateSkin(const SkinRecipe& recipe, int width, int height,
                                   std::uint64_t seed, const ParameterAxes& axes,
                                   const std::shared_ptr<TileStore>& store,
                                   const JobContext& context);

}  // namespace cutis
