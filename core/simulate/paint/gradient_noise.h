#pragma once

// Gradient noise (Perlin 1985, with the quintic of 2002) on a hashed lattice: mean 0, standard
// deviation about 1, never beyond ±3.3, correlated over one lattice cell.

#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/base/rect.h"
#include "core/simulate/paint/patch_tile.h"
#include "core/simulate/paint/skin_recipe.h"

namespace cutis {

// Independent noises have independent keys.
inline std::uint64_t noiseKey(std::uint64_t seed, std::uint64_t stream) {
  return mixBits(seed ^ mixBits(~stream));
}
inline std::uint64_t latticeBits(std::uint64_t key, int column, int row) {
  return mixBits(key + static_cast<std::uint64_t>(column) * 0xd1342543de82ef95u +
                 static_cast<std::uint64_t>(row) * 0xaf251af3b0f025b5u);
}

// The noise at one point, in units of the lattice.
float gradientNoise(std::uint64_t key, float x, float y);

// One octave over the rows of a rectangle, much cheaper than point by point.
class NoiseRows {
 public:
  // A lattice of `cell` pixels, moved by (offsetX, offsetY) lattice units: octaves whose lattices
  // coincide would show them.
  NoiseRows(std::uint64_t key, float cell, float offsetX, float offsetY, const Rect& rect);

  // out[x − rect.x0] += weight · gradientNoise(key, (x + ½) / cell + offsetX, (y + ½) / cell +
  // offsetY). Rows in order cost least.
  void add(int y, float weight, float* out);

 private:
  struct Gradient {
    float x, y;
  };
  void loadLattice(int row, std::vector<Gradient>& gradients) const;
  void loadRow(int row);

  std::uint64_t key_;
  float cell_, offsetY_;
  int firstColumn_;
  int latticeRow_ = 0;
  std::vector<std::size_t> starts_;  // first pixel of each cell along the row
  std::vector<float> dx_, fade_;     // each pixel's place in its cell
  std::vector<Gradient> above_, below_;
};

// The octaves of a NoiseRecipe; those too fine for the picture's pixels fade out.
class FractalRows {
 public:
  FractalRows(const NoiseRecipe& recipe, std::uint64_t key, const PatchFrame& frame,
              const Rect& rect);

  // out[x − rect.x0] = noise with the recipe's deviation.
  void row(int y, float* out);

 private:
  struct Octave {
    NoiseRows rows;
    float weight;
  };
  std::size_t width_;
  std::vector<Octave> octaves_;
};

}  // namespace cutis
