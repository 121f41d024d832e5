#include "core/fit/tile_order.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>
#include <utility>

namespace cutis {
namespace {

// Four times the square of the distance between the middles.
std::int64_t squaredDistance(const Rect& a, const Rect& b) {
  const std::int64_t dx = std::int64_t{a.x0} + a.x1 - b.x0 - b.x1;
  const std::int64_t dy = std::int64_t{a.y0} + a.y1 - b.y0 - b.y1;
  return dx * dx + dy * dy;
}

}  // namespace

TileOrder::TileOrder(std::vector<Rect> tiles) : tiles_(std::move(tiles)), left_(tiles_.size()) {
  std::iota(left_.begin(), left_.end(), std::size_t{0});
}

std::size_t TileOrder::next(const Rect& view) {
  const std::lock_guard lock(mutex_);
  assert(!left_.empty());
  auto chosen = left_.begin();
  if (!view.empty()) {
    chosen = std::min_element(left_.begin(), left_.end(), [&](std::size_t a, std::size_t b) {
      return squaredDistance(tiles_[a], view) < squaredDistance(tiles_[b], view);
    });
  }
  const std::size_t tile = *chosen;
  left_.erase(chosen);
  return tile;
}

}  // namespace cutis
