#pragma once

// Places of a drawing: pixels, x to the right and y downwards.

namespace cutis {

struct Point {
  double x = 0.0;
  double y = 0.0;

  bool operator==(const Point&) const = default;
};

// Half-open on no side: boxes that touch do not overlap.
struct Box {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  Point centre() const { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
  bool overlaps(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  bool holds(const Box& other) const {
    return left <= other.left && top <= other.top && other.right <= right && other.bottom <= bottom;
  }
  bool holds(Point p) const { return left <= p.x && p.x <= right && top <= p.y && p.y <= bottom; }

  bool operator==(const Box&) const = default;
};

}  // namespace cutis
