#pragma once

// One channel of a picture, in tiles.
//
// Values are floats outside and float or half inside. A plane starts as zeros that cost no memory;
// a tile exists once something was stored in it. Rectangles are half-open and packed row by row.
// Copies share their pixels: a Plane is a handle, like a shared pointer to a picture.
//
// Thread-safe: any number of threads may load and store at once; a load sees each tile either as it
// was before a store or as it is after. Two threads that store into the same tile at once may lose
// one of the two, so work is divided by tiles (tileRect). Errors: no memory, no disk (TileStore).

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/base/tile_store.h"

namespace cutis {

enum class PixelFormat : std::uint8_t { float32, half };

class Plane {
 public:
  static constexpr int kTileSize = 256;

  // A plane of no pixels.
  Plane() = default;
  // Without a store of its own the plane lives in memory, unlimited.
  Plane(int width, int height, PixelFormat format = PixelFormat::float32,
        std::shared_ptr<TileStore> store = nullptr);

  int width() const;
  int height() const;
  Rect bounds() const { return {0, 0, width(), height()}; }
  PixelFormat format() const;
  bool empty() const { return width() == 0 || height() == 0; }

  // Tiles are numbered row by row; those at the right and lower edge may be smaller.
  int tileCount() const;
  Rect tileRect(int index) const;

  // Precondition: rect lies within bounds() and out has rect.pixelCount() elements.
  Status load(const Rect& rect, std::span<float> out) const;
  // Precondition: the same. Storing a whole tile costs one copy; a part of one, three.
  Status store(const Rect& rect, std::span<const float> in);

 private:
  struct Pixels;
  std::shared_ptr<Pixels> pixels_;
};

}  // namespace cutis
