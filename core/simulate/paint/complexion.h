#pragma once  // internal to core/simulate/paint

// What every pixel of the patch has: its tone, the colour of large areas, the relief's fine lines
// and variation at all scales in all parameters.

#include <cstdint>

#include "core/simulate/paint/patch_tile.h"
#include "core/simulate/paint/skin_recipe.h"

namespace cutis {

// Sets every pixel of the tile.
void paintComplexion(const SkinRecipe& recipe, const PatchFrame& frame, std::uint64_t seed,
                     PatchTile& tile);

}  // namespace cutis
