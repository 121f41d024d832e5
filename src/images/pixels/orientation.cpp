#include "src/images/pixels/orientation.h"

#include <cassert>
#include <cstddef>

namespace cutis {
namespace {

struct Turn {
  bool swapsAxes = false;
  bool fromRight = false;   // stored columns run against those of the upright picture
  bool fromBottom = false;  // stored rows do
};

Turn turnOf(Orientation orientation) {
  switch (orientation) {
    case Orientation::upright:
      return {};
    case Orientation::mirrored:
      return {false, true, false};
    case Orientation::upsideDown:
      return {false, true, true};
    case Orientation::flipped:
      return {false, false, true};
    case Orientation::transposed:
      return {true, false, false};
    case Orientation::lyingLeft:
      return {true, false, true};
    case Orientation::antiTransposed:
      return {true, true, true};
    case Orientation::lyingRight:
      return {true, true, false};
  }
  return {};
}

}  // namespace

Orientation orientationOf(int tag) {
  return tag >= 1 && tag <= 8 ? static_cast<Orientation>(tag) : Orientation::upright;
}

bool swapsSides(Orientation orientation) {
  return turnOf(orientation).swapsAxes;
}

Rect uprightRect(const Rect& stored, int width, int height, Orientation orientation) {
  const Turn turn = turnOf(orientation);
  Rect turned = stored;
  if (turn.fromRight) {
    turned.x0 = width - stored.x1;
    turned.x1 = width - stored.x0;
  }
  if (turn.fromBottom) {
    turned.y0 = height - stored.y1;
    turned.y1 = height - stored.y0;
  }
  return turn.swapsAxes ? Rect{turned.y0, turned.x0, turned.y1, turned.x1} : turned;
}

void turnUpright(std::span<const float> stored, int width, int height, Orientation orientation,
                 std::span<float> upright) {
  assert(stored.size() == upright.size());
  const Turn turn = turnOf(orientation);
  const int columns = turn.swapsAxes ? height : width;
  const int rows = turn.swapsAxes ? width : height;
  std::size_t next = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int a = turn.swapsAxes ? row : column;
      const int b = turn.swapsAxes ? column : row;
      const int x = turn.fromRight ? width - 1 - a : a;
      const int y = turn.fromBottom ? height - 1 - b : b;
      upright[next++] = stored[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x)];
    }
  }
}

}  // namespace cutis
