#pragma once

// Paints rectangles of a procedural patch.

#include <cstdint>
#include <vector>

#include "core/simulate/paint/lips.h"
#include "core/simulate/paint/patch_tile.h"
#include "core/simulate/paint/skin_recipe.h"
#include "core/simulate/paint/veins.h"

namespace cutis {

// Thread-safe: const after construction.
class PatchPainter {
 public:
  PatchPainter(const SkinRecipe& recipe, const PatchFrame& frame, std::uint64_t seed);
  PatchPainter(const PatchPainter&) = delete;
  PatchPainter& operator=(const PatchPainter&) = delete;

  // Parameters of all pixels of rect as if there were skin everywhere, within no range yet.
  PatchTile paint(const Rect& rect) const;
  // 1 where there is skin, else 0, row by row.
  std::vector<float> mask(const Rect& rect) const;

 private:
  const SkinRecipe recipe_;
  const PatchFrame frame_;
  const std::uint64_t seed_;
  const Veins veins_;
  const Lips lips_;
};

}  // namespace cutis
