#pragma once  // internal to src/report/plot

// The parts of lines that lie within a box.

#include <span>
#include <vector>

#include "src/report/geometry.h"

namespace cutis {

// The pieces of a line; points that are not finite leave gaps. A piece has at least two points.
std::vector<std::vector<Point>> clipped(std::span<const Point> line, const Box& box);

}  // namespace cutis
