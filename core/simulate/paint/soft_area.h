#pragma once  // internal to core/simulate/paint

// A SoftArea of a recipe, in pixels.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/simulate/paint/patch_tile.h"
#include "core/simulate/paint/skin_recipe.h"

namespace cutis {

inline float radians(double degrees) {
  return static_cast<float>(degrees * std::numbers::pi / 180.0);
}

class AreaShape {
 public:
  AreaShape(const SoftArea& area, const PatchFrame& frame)
      : x_(frame.x(area.x)),
        y_(frame.y(area.y)),
        reach_(frame.length(std::max(area.radiusX, area.radiusY))),
        alongX_(std::cos(radians(area.angle)) / frame.length(area.radiusX)),
        alongY_(std::sin(radians(area.angle)) / frame.length(area.radiusX)),
        acrossX_(-std::sin(radians(area.angle)) / frame.length(area.radiusY)),
        acrossY_(std::cos(radians(area.angle)) / frame.length(area.radiusY)) {}

  // 1 at the centre, 0 from the rim.
  float weight(float x, float y) const {
    const float along = (x - x_) * alongX_ + (y - y_) * alongY_;
    const float across = (x - x_) * acrossX_ + (y - y_) * acrossY_;
    const float inside = std::max(0.0f, 1.0f - along * along - across * across);
    return inside * inside;
  }

  // Whether a pixel of rect may lie within `margin` pixels of the area.
  bool mayTouch(const Rect& rect, float margin) const {
    return !intersection(rect, pixelsAround(x_, y_, reach_ + margin)).empty();
  }

 private:
  float x_, y_, reach_;
  float alongX_, alongY_, acrossX_, acrossY_;
};

// Areas that overlap: the strongest counts.
class AreaShapes {
 public:
  AreaShapes(const std::vector<SoftArea>& areas, const PatchFrame& frame) {
    for (const SoftArea& area : areas)
      shapes_.emplace_back(area, frame);
  }

  float weight(float x, float y) const {
    float most = 0.0f;
    for (const AreaShape& shape : shapes_)
      most = std::max(most, shape.weight(x, y));
    return most;
  }
  bool mayTouch(const Rect& rect, float margin) const {
    return std::any_of(shapes_.begin(), shapes_.end(),
                       [&](const AreaShape& shape) { return shape.mayTouch(rect, margin); });
  }

 private:
  std::vector<AreaShape> shapes_;
};

}  // namespace cutis
