#pragma once  // internal to core/simulate/paint

// Branching vessels, seen as bands of more blood in the dermis.

#include <cstdint>
#include <vector>

#include "core/simulate/paint/patch_tile.h"
#include "core/simulate/paint/skin_recipe.h"

namespace cutis {

// A straight piece of a vessel, in pixels.
struct VeinSegment {
  float x0, y0, x1, y1;
  float radius;             // where its blood has faded to nothing
  float dermal, epidermal;  // haemoglobin added along the axis
};

// Thread-safe: const after construction.
class Veins {
 public:
  // Grows all vessels once (some hundred segments).
  Veins(const std::vector<VeinRecipe>& recipes, const PatchFrame& frame, std::uint64_t seed);

  void paint(PatchTile& tile) const;
  const std::vector<VeinSegment>& segments() const { return segments_; }

 private:
  std::vector<VeinSegment> segments_;
};

}  // namespace cutis
