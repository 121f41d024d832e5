#pragma once  // internal to core/simulate/paint

// Short dark hairs of a shaven beard.

#include <cstdint>

#include "core/simulate/paint/lips.h"
#include "core/simulate/paint/patch_tile.h"
#include "core/simulate/paint/skin_recipe.h"

namespace cutis {

// No hair has its root on the lips.
void paintStubble(const StubbleRecipe& recipe, const Lips& lips, const PatchFrame& frame,
                  std::uint64_t seed, PatchTile& tile);

}  // namespace cutis
