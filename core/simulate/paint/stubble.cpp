#include "core/simulate/paint/stubble.h"

#include <cmath>
#include <cstddef>

#include "core/simulate/paint/gradient_noise.h"
#include "core/simulate/paint/soft_area.h"

namespace cutis {
namespace {

constexpr std::uint64_t kStubbleStream = 500;

// A hair from its root to its tip, slightly bent.
struct Hair {
  float x, y;            // root, pixels
  float alongX, alongY;  // unit direction at the root
  float length, radius;  // pixels
  float bend;            // sideways at the tip, pixels
};

// Share of each pixel of the tile that the hair covers.
template <typename Visit>
void draw(const Hair& hair, PatchTile& tile, Visit visit) {
  const float reach = hair.radius + 1.0f + std::abs(hair.bend);
  const Rect root = pixelsAround(hair.x, hair.y, reach);
  const Rect tip =
      pixelsAround(hair.x + hair.alongX * hair.length, hair.y + hair.alongY * hair.length, reach);
  const Rect rect = intersection(tile.rect, unite(root, tip));
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      const float dx = static_cast<float>(x) + 0.5f - hair.x;
      const float dy = static_cast<float>(y) + 0.5f - hair.y;
      const float along = dx * hair.alongX + dy * hair.alongY;
      const float t = along / hair.length;
      const float aside = dy * hair.alongX - dx * hair.alongY - hair.bend * t * t;
      const float radius = hair.radius * (1.0f - 0.5f * std::clamp(t, 0.0f, 1.0f));
      // Overlap of the pixel, a box of width 1, with the hair's width and with its length.
      const float across =
          std::min(std::abs(aside) + 0.5f, radius) - std::max(std::abs(aside) - 0.5f, -radius);
      const float lengthwise = std::min(along + 0.5f, hair.length) - std::max(along - 0.5f, 0.0f);
      if (across <= 0.0f || lengthwise <= 0.0f) continue;
      visit(tile.index(x, y), std::min(across, 1.0f) * std::min(lengthwise, 1.0f));
    }
  }
}

}  // namespace

void paintStubble(const StubbleRecipe& recipe, const Lips& lips, const PatchFrame& frame,
                  std::uint64_t seed, PatchTile& tile) {
  const float spacing = frame.length(recipe.spacing);
  const float length = frame.length(recipe.length);
  const AreaShapes areas(recipe.areas, frame);
  const float reach = 1.6f * length + 2.0f;
  if (length < 0.3f || spacing < kSmallestSpacing || !areas.mayTouch(tile.rect, reach)) return;
  const std::uint64_t key = noiseKey(seed, kStubbleStream);
  const auto melanin = static_cast<float>(recipe.melanin);
  const auto blend = static_cast<float>(recipe.blend);
  forEachCell(tile.rect, spacing, reach, [&](int i, int j) {
    Random random(latticeBits(key, i, j));
    const float x = (static_cast<float>(i) + static_cast<float>(random.uniform())) * spacing;
    const float y = (static_cast<float>(j) + static_cast<float>(random.uniform())) * spacing;
    const float weight = std::sqrt(areas.weight(x, y));
    if (static_cast<float>(random.uniform()) >= weight * static_cast<float>(recipe.chance)) return;
    if (lips.depth(x, y) > -0.004f * frame.side()) return;
    const float turn = gradientNoise(key, x / frame.length(0.12), y / frame.length(0.12));
    const float angle =
        radians(recipe.angle) +
        radians(recipe.spread) * (0.7f * turn + 0.7f * static_cast<float>(random.normal()));
    const float size = static_cast<float>(random.uniform(0.5, 1.5)) * (0.6f + 0.4f * weight);
    const Hair hair = {
        x,
        y,
        std::cos(angle),
        std::sin(angle),
        length * size,
        0.5f * frame.length(recipe.width) * static_cast<float>(random.uniform(0.5, 1.3)),
        length * size * static_cast<float>(0.12 * random.normal())};
    draw(hair, tile, [&](std::size_t at, float cover) {
      const auto set = [&](Parameter parameter, float value, float share) {
        float& old = tile.at(parameter, at);
        old = mix(old, value, share);
      };
      set(kMelanin, melanin, cover);
      set(kMelaninBlend, blend, std::sqrt(cover));
    });
  });
}

}  // namespace cutis
