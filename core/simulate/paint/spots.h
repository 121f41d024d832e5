#pragma once  // internal to core/simulate/paint

// Round features: pores, freckles and moles.

#include <cstdint>
#include <vector>

#include "core/simulate/paint/patch_tile.h"
#include "core/simulate/paint/skin_recipe.h"
#include "core/simulate/paint/soft_area.h"

namespace cutis {

void paintPores(const PoreRecipe& recipe, const PatchFrame& frame, std::uint64_t seed,
                PatchTile& tile);
void paintFreckles(const FreckleRecipe& recipe, const PatchFrame& frame, std::uint64_t seed,
                   PatchTile& tile);
void paintMoles(const std::vector<MoleRecipe>& moles, const PatchFrame& frame, std::uint64_t seed,
                PatchTile& tile);

}  // namespace cutis
