#include "core/simulate/paint/veins.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/simulate/paint/gradient_noise.h"
#include "core/simulate/paint/soft_area.h"

namespace cutis {
namespace {

constexpr std::uint64_t kVeinStream = 400;
constexpr int kDeepestBranch = 3;

struct Vessel {
  double x, y;    // pixels
  double angle;   // radians
  double length;  // pixels
  double radius;  // pixels
  double blood;   // share of the recipe's
  int depth;      // 0 for the trunk
};

class Grower {
 public:
  Grower(const VeinRecipe& recipe, const PatchFrame& frame, std::uint64_t key,
         std::vector<VeinSegment>& segments)
      : recipe_(recipe), side_(frame.side()), random_(key), segments_(segments) {}

  void grow(const Vessel& vessel) {
    const double step = 0.006 * side_;
    const int steps = std::max(2, static_cast<int>(vessel.length / step));
    double x = vessel.x, y = vessel.y;
    double bend = 0.0;
    double toBranch = recipe_.branchEvery * side_ * random_.uniform(0.3, 1.0);
    for (int i = 0; i < steps; ++i) {
      const double along = static_cast<double>(i) / steps;
      // Winds, and returns to its course.
      bend += 0.26 * recipe_.wander * random_.normal() - 0.12 * bend;
      const double angle = vessel.angle + bend;
      const double nextX = x + step * std::cos(angle);
      const double nextY = y + step * std::sin(angle);
      // Thin at its end; a branch also rises from the depth at its root.
      const double taper = 1.0 - 0.65 * along;
      const double rise = vessel.depth == 0 ? std::min(1.0, 0.2 + 6.0 * along) : 1.0;
      const double sink = std::min(1.0, 4.0 * (1.0 - along));
      segments_.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(nextX),
                           static_cast<float>(nextY), static_cast<float>(vessel.radius * taper),
                           static_cast<float>(recipe_.dermal * vessel.blood * rise * sink),
                           static_cast<float>(recipe_.epidermal * vessel.blood * rise * sink)});
      x = nextX;
      y = nextY;
      toBranch -= step;
      if (toBranch > 0.0 || vessel.depth == kDeepestBranch) continue;
      toBranch = recipe_.branchEvery * side_ * random_.uniform(0.6, 1.4);
      const double turn = (random_.uniform() < 0.5 ? -1.0 : 1.0) * random_.uniform(0.5, 1.1);
      const double left = vessel.length * (1.0 - along);
      grow({x, y, angle + turn, left * random_.uniform(0.35, 0.7), 0.75 * vessel.radius * taper,
            0.85 * vessel.blood, vessel.depth + 1});
    }
  }

 private:
  const VeinRecipe& recipe_;
  double side_;
  Random random_;
  std::vector<VeinSegment>& segments_;
};

float squaredDistance(const VeinSegment& s, float x, float y) {
  const float dx = s.x1 - s.x0;
  const float dy = s.y1 - s.y0;
  const float along = ((x - s.x0) * dx + (y - s.y0) * dy) / std::max(dx * dx + dy * dy, 1e-12f);
  const float t = std::clamp(along, 0.0f, 1.0f);
  const float ex = x - s.x0 - t * dx;
  const float ey = y - s.y0 - t * dy;
  return ex * ex + ey * ey;
}

}  // namespace

Veins::Veins(const std::vector<VeinRecipe>& recipes, const PatchFrame& frame, std::uint64_t seed) {
  const std::uint64_t key = noiseKey(seed, kVeinStream);
  for (std::size_t k = 0; k < recipes.size(); ++k) {
    const VeinRecipe& recipe = recipes[k];
    Grower grower(recipe, frame, latticeBits(key, static_cast<int>(k), 0), segments_);
    grower.grow({frame.x(recipe.x), frame.y(recipe.y), radians(recipe.angle),
                 frame.length(recipe.length), 0.5 * frame.length(recipe.width), 1.0, 0});
  }
  // One thinner than a pixel is spread over it.
  constexpr float kPixel = 0.9f;
  for (VeinSegment& segment : segments_) {
    const float share = std::min(1.0f, segment.radius / kPixel);
    segment.dermal *= share;
    segment.epidermal *= share;
    segment.radius = std::max(segment.radius, kPixel);
  }
}

void Veins::paint(PatchTile& tile) const {
  // Pieces overlap where they join: the pixel keeps the most of any.
  std::vector<float> dermal, epidermal;
  for (const VeinSegment& segment : segments_) {
    const float radius = segment.radius;
    const Rect rect = intersection(tile.rect, unite(pixelsAround(segment.x0, segment.y0, radius),
                                                    pixelsAround(segment.x1, segment.y1, radius)));
    if (rect.empty()) continue;
    dermal.resize(tile.rect.pixelCount());
    epidermal.resize(tile.rect.pixelCount());
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) {
        const float squared =
            squaredDistance(segment, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f) /
            (radius * radius);
        if (squared >= 1.0f) continue;
        const float weight = (1.0f - squared) * (1.0f - squared);
        const std::size_t at = tile.index(x, y);
        dermal[at] = std::max(dermal[at], segment.dermal * weight);
        epidermal[at] = std::max(epidermal[at], segment.epidermal * weight);
      }
    }
  }
  for (std::size_t i = 0; i < dermal.size(); ++i) {
    tile.at(kHaemoglobinDermal, i) += dermal[i];
    tile.at(kHaemoglobinEpidermal, i) += epidermal[i];
  }
}

}  // namespace cutis
