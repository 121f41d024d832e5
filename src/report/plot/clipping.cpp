#include "src/report/plot/clipping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace cutis {
namespace {

bool isFinite(Point p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

// Liang and Barsky (1984): the part of a segment within a box, as shares of its length.
std::optional<std::pair<double, double>> insideShares(Point from, Point to, const Box& box) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const std::array<std::pair<double, double>, 4> sides = {{{-dx, from.x - box.left},
                                                           {dx, box.right - from.x},
                                                           {-dy, from.y - box.top},
                                                           {dy, box.bottom - from.y}}};
  double first = 0.0, last = 1.0;
  for (const auto& [towards, room] : sides) {
    if (towards == 0.0) {
      if (room < 0.0) return {};
    } else if (towards < 0.0) {
      first = std::max(first, room / towards);
    } else {
      last = std::min(last, room / towards);
    }
  }
  if (first > last) return {};
  return std::pair(first, last);
}

}  // namespace

std::vector<std::vector<Point>> clipped(std::span<const Point> line, const Box& box) {
  std::vector<std::vector<Point>> pieces;
  bool joined = false;  // whether the last piece ends where the next segment begins
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point from = line[i - 1], to = line[i];
    const auto shares = isFinite(from) && isFinite(to) ? insideShares(from, to, box) : std::nullopt;
    if (!shares) {
      joined = false;
      continue;
    }
    const auto at = [&](double share) -> Point {
      if (share == 0.0) return from;
      if (share == 1.0) return to;
      return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
    };
    if (!joined || shares->first > 0.0) pieces.push_back({at(shares->first)});
    pieces.back().push_back(at(shares->second));
    joined = shares->second == 1.0;
  }
  return pieces;
}

}  // namespace cutis
