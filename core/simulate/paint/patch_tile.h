#pragma once  // internal to core/simulate/paint

// The picture that a patch is painted on: its size in pixels, and one rectangle of it in memory.
//
// What is painted into a pixel is a function of the pixel's own coordinates, never of the rectangle
// it was painted in: features are visited in an order of their own, so that any division of the
// patch gives the same bits.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/base/rect.h"
#include "core/skin/profile/parameter.h"

namespace cutis {

// Pixel centres lie at half coordinates.
struct PatchFrame {
  int width = 1;
  int height = 1;

  float side() const { return static_cast<float>(std::min(width, height)); }
  // Recipe to pixels.
  float x(double fraction) const { return static_cast<float>(fraction * width); }
  float y(double fraction) const { return static_cast<float>(fraction * height); }
  float length(double fraction) const { return static_cast<float>(fraction) * side(); }
};

struct PatchTile {
  explicit PatchTile(const Rect& r) : rect(r) {
    for (std::vector<float>& plane : values)
      plane.assign(rect.pixelCount(), 0.0f);
  }

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - rect.y0) * static_cast<std::size_t>(rect.width()) +
           static_cast<std::size_t>(x - rect.x0);
  }
  float& at(Parameter parameter, std::size_t pixel) {
    return values[static_cast<std::size_t>(parameter)][pixel];
  }

  Rect rect;
  std::array<std::vector<float>, kParameterCount> values;  // indexed by Parameter, row by row
};

inline float mix(float from, float to, float share) {
  return from + share * (to - from);
}

// 0 below `from`, 1 above `to`, smooth between; from < to.
inline float smoothStep(float from, float to, float value) {
  const float t = std::clamp((value - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

// Pixels whose centres may lie within `reach` of (x, y).
inline Rect pixelsAround(float x, float y, float reach) {
  return {static_cast<int>(std::floor(x - reach)), static_cast<int>(std::floor(y - reach)),
          static_cast<int>(std::ceil(x + reach)) + 1, static_cast<int>(std::ceil(y + reach)) + 1};
}

// The smallest rectangle around both.
inline Rect unite(const Rect& a, const Rect& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

// A grid finer than this many pixels is left out: nothing of it would be seen.
inline constexpr float kSmallestSpacing = 0.05f;

// Calls visit(column, row) for the cells of a grid of `spacing` pixels that lie within `reach` of
// rect, row by row.
template <typename Visit>
void forEachCell(const Rect& rect, float spacing, float reach, Visit visit) {
  const auto cell = [&](float pixel) { return static_cast<int>(std::floor(pixel / spacing)); };
  const int lastRow = cell(static_cast<float>(rect.y1) + reach);
  const int lastColumn = cell(static_cast<float>(rect.x1) + reach);
  for (int j = cell(static_cast<float>(rect.y0) - reach); j <= lastRow; ++j) {
    for (int i = cell(static_cast<float>(rect.x0) - reach); i <= lastColumn; ++i)
      visit(i, j);
  }
}

}  // namespace cutis
