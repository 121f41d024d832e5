#pragma once  // internal to core/fit

// Which tile of a picture is solved next: the one nearest to what somebody looks at.

#include <cstddef>
#include <mutex>
#include <vector>

#include "core/base/rect.h"

namespace cutis {

// Hands out each tile once. Thread-safe. Changes when a tile is solved, never what comes out.
class TileOrder {
 public:
  explicit TileOrder(std::vector<Rect> tiles);

  // Index of the tile that is left whose middle is nearest to the middle of the view, the lowest of
  // equally near ones; for an empty view simply the lowest. Precondition: some tile is left.
  std::size_t next(const Rect& view);

 private:
  std::mutex mutex_;
  std::vector<Rect> tiles_;
  std::vector<std::size_t> left_;  // increasing
};

}  // namespace cutis
