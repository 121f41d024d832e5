#pragma once  // internal to core/simulate/paint

// A closed mouth: two lips with a soft border, fine lines across them and the dark line between.

#include <cstdint>

#include "core/simulate/paint/patch_tile.h"
#include "core/simulate/paint/skin_recipe.h"

namespace cutis {

// Thread-safe: const after construction.
class Lips {
 public:
  Lips(const LipsRecipe& recipe, const PatchFrame& frame, std::uint64_t seed);

  // How deep (x, y) lies within the lips, in pixels; negative outside, there a rough distance.
  float depth(float x, float y) const;
  void paint(PatchTile& tile) const;

 private:
  struct Place;
  struct Texture;

  Place placeOf(float x, float y) const;
  float depth(const Place& place) const;
  float cover(const Place& place) const;
  Texture textureAt(const Place& place) const;

  LipsRecipe recipe_;
  std::uint64_t key_;
  float x_, y_, halfWidth_, softness_;
  float cosine_, sine_;
};

}  // namespace cutis
