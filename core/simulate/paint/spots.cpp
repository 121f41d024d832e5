#include "core/simulate/paint/spots.h"

#include <cmath>
#include <cstddef>

#include "core/simulate/paint/gradient_noise.h"

namespace cutis {
namespace {

enum SpotStream : std::uint64_t { kPores = 200, kFreckles, kMoles };

// Below this radius in pixels a feature has no share in any pixel worth computing.
constexpr float kSmallestRadius = 0.1f;

struct Spot {
  float x, y;      // centre, pixels
  float radius;    // pixels
  float softness;  // share of the radius over which it fades
  float ragged;    // how far its outline strays, relative
  std::uint64_t key;
};

// Calls visit(index, weight) for the pixels of the tile under the spot. One smaller than a pixel
// is spread over it with the weight of its area.
template <typename Visit>
void splat(const Spot& spot, PatchTile& tile, Visit visit) {
  constexpr float kPixel = 0.8f;
  const float radius = std::max(spot.radius, kPixel);
  const float share = std::min(1.0f, spot.radius * spot.radius / (kPixel * kPixel));
  const float reach = radius * (1.0f + spot.ragged);
  const Rect rect = intersection(tile.rect, pixelsAround(spot.x, spot.y, reach));
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      const float dx = (static_cast<float>(x) + 0.5f - spot.x) / radius;
      const float dy = (static_cast<float>(y) + 0.5f - spot.y) / radius;
      const float squared = dx * dx + dy * dy;
      if (squared * radius * radius > reach * reach) continue;
      float distance = std::sqrt(squared);
      if (spot.ragged > 0.0f) {
        distance += 0.5f * spot.ragged * gradientNoise(spot.key, 1.2f * dx, 1.2f * dy);
      }
      const float weight = 1.0f - smoothStep(1.0f - spot.softness, 1.0f, distance);
      if (weight > 0.0f) visit(tile.index(x, y), share * weight);
    }
  }
}

}  // namespace

void paintPores(const PoreRecipe& recipe, const PatchFrame& frame, std::uint64_t seed,
                PatchTile& tile) {
  const float spacing = frame.length(recipe.spacing);
  const float radius = frame.length(recipe.radius);
  if (radius < kSmallestRadius || spacing < kSmallestSpacing) return;
  const std::uint64_t key = noiseKey(seed, kPores);
  forEachCell(tile.rect, spacing, 2.0f * radius + 1.0f, [&](int i, int j) {
    Random random(latticeBits(key, i, j));
    const auto draw = [&](double from, double to) {
      return static_cast<float>(random.uniform(from, to));
    };
    const float x = (static_cast<float>(i) + draw(0.1, 0.9)) * spacing;
    const float y = (static_cast<float>(j) + draw(0.1, 0.9)) * spacing;
    const float depth = draw(0.1, 1.0);
    const Spot pore = {x, y, radius * draw(0.6, 1.4), 1.0f, 0.0f, 0};
    splat(pore, tile, [&](std::size_t at, float weight) {
      const float w = weight * depth;
      tile.at(kMelanin, at) *= 1.0f + w * static_cast<float>(recipe.melanin);
      tile.at(kHaemoglobinDermal, at) *= 1.0f + w * static_cast<float>(recipe.dermal);
      tile.at(kHaemoglobinEpidermal, at) += w * static_cast<float>(recipe.epidermal);
    });
  });
}

void paintFreckles(const FreckleRecipe& recipe, const PatchFrame& frame, std::uint64_t seed,
                   PatchTile& tile) {
  constexpr float kLargest = 3.0f;  // of the median
  constexpr float kRagged = 0.45f;
  const float spacing = frame.length(recipe.spacing);
  const float median = frame.length(recipe.radius);
  if (median < kSmallestRadius || spacing < kSmallestSpacing) return;
  const std::uint64_t key = noiseKey(seed, kFreckles);
  const AreaShapes areas(recipe.areas, frame);
  forEachCell(tile.rect, spacing, kLargest * median * (1.0f + kRagged) + 1.0f, [&](int i, int j) {
    Random random(latticeBits(key, i, j));
    const float x = (static_cast<float>(i) + static_cast<float>(random.uniform())) * spacing;
    const float y = (static_cast<float>(j) + static_cast<float>(random.uniform())) * spacing;
    if (random.uniform() >= recipe.scatter + recipe.chance * areas.weight(x, y)) return;
    const auto size = static_cast<float>(std::exp(recipe.spread * random.normal()));
    const float strength =
        static_cast<float>(recipe.strength * (0.2 + 0.8 * std::pow(random.uniform(), 1.5)));
    const auto blend = static_cast<float>(recipe.blend);
    const Spot freckle = {x, y, median * std::min(size, kLargest), 0.75f, kRagged, random.bits()};
    splat(freckle, tile, [&](std::size_t at, float weight) {
      const float added = weight * strength;
      tile.at(kMelanin, at) *= 1.0f + added;
      float& blended = tile.at(kMelaninBlend, at);
      blended = mix(blended, blend, added / (1.0f + added));
    });
  });
}

void paintMoles(const std::vector<MoleRecipe>& moles, const PatchFrame& frame, std::uint64_t seed,
                PatchTile& tile) {
  const std::uint64_t key = noiseKey(seed, kMoles);
  for (std::size_t k = 0; k < moles.size(); ++k) {
    const MoleRecipe& mole = moles[k];
    const float radius = frame.length(mole.radius);
    if (radius < kSmallestRadius) continue;
    const Spot spot = {frame.x(mole.x), frame.y(mole.y),
                       radius,          0.7f,
                       0.25f,           latticeBits(key, static_cast<int>(k), 0)};
    splat(spot, tile, [&](std::size_t at, float weight) {
      float& melanin = tile.at(kMelanin, at);
      const float more = std::max(1.0f, static_cast<float>(mole.melanin) / melanin);
      melanin *= std::pow(more, weight);
      float& blend = tile.at(kMelaninBlend, at);
      blend = mix(blend, static_cast<float>(mole.blend), std::sqrt(weight));
    });
  }
}

}  // namespace cutis
