#include "core/simulate/paint/patch_painter.h"

#include <cmath>
#include <cstddef>

#include "core/simulate/paint/complexion.h"
#include "core/simulate/paint/gradient_noise.h"
#include "core/simulate/paint/spots.h"
#include "core/simulate/paint/stubble.h"

namespace cutis {
namespace {

constexpr std::uint64_t kOutlineStream = 600;

// |distance of a pixel centre from the middle over the radius| to the exponent.
std::vector<float> powers(int from, int to, int size, double radius, double exponent) {
  std::vector<float> out;
  for (int i = from; i < to; ++i) {
    const double distance = std::abs((i + 0.5) / size - 0.5) / radius;
    out.push_back(static_cast<float>(std::pow(distance, exponent)));
  }
  return out;
}

}  // namespace

PatchPainter::PatchPainter(const SkinRecipe& recipe, const PatchFrame& frame, std::uint64_t seed)
    : recipe_(recipe),
      frame_(frame),
      seed_(seed),
      veins_(recipe.veins, frame, seed),
      lips_(recipe.lips, frame, seed) {}

PatchTile PatchPainter::paint(const Rect& rect) const {
  PatchTile tile(rect);
  paintComplexion(recipe_, frame_, seed_, tile);
  veins_.paint(tile);
  paintPores(recipe_.pores, frame_, seed_, tile);
  paintFreckles(recipe_.freckles, frame_, seed_, tile);
  lips_.paint(tile);
  paintMoles(recipe_.moles, frame_, seed_, tile);
  paintStubble(recipe_.stubble, lips_, frame_, seed_, tile);
  return tile;
}

std::vector<float> PatchPainter::mask(const Rect& rect) const {
  const SilhouetteRecipe& shape = recipe_.silhouette;
  const std::vector<float> across =
      powers(rect.x0, rect.x1, frame_.width, shape.radiusX, shape.exponent);
  const std::vector<float> down =
      powers(rect.y0, rect.y1, frame_.height, shape.radiusY, shape.exponent);
  FractalRows outline({shape.wobble * shape.exponent, 0.3, 3, 0.5}, noiseKey(seed_, kOutlineStream),
                      frame_, rect);
  std::vector<float> inside(rect.pixelCount());
  std::vector<float> wobble(across.size());
  for (std::size_t y = 0; y < down.size(); ++y) {
    outline.row(rect.y0 + static_cast<int>(y), wobble.data());
    for (std::size_t x = 0; x < across.size(); ++x) {
      inside[y * across.size() + x] = across[x] + down[y] < 1.0f + wobble[x] ? 1.0f : 0.0f;
    }
  }
  return inside;
}

}  // namespace cutis
