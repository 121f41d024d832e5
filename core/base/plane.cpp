#include "core/base/plane.h"

#include <cassert>
#include <cstring>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include "core/base/half.h"

namespace cutis {

// A tile keeps only the pixels inside the picture, row by row.
struct Plane::Pixels {
  Pixels(int w, int h, PixelFormat f, std::shared_ptr<TileStore> s)
      : width(w),
        height(h),
        tilesAcross((w + kTileSize - 1) / kTileSize),
        tilesDown((h + kTileSize - 1) / kTileSize),
        format(f),
        store(std::move(s)),
        keys(static_cast<std::size_t>(tilesAcross) * static_cast<std::size_t>(tilesDown), 0) {}
  Pixels(const Pixels&) = delete;
  Pixels& operator=(const Pixels&) = delete;
  ~Pixels() {
    for (const TileStore::Key key : keys) {
      if (key != 0) store->remove(key);
    }
  }

  std::size_t pixelBytes() const { return format == PixelFormat::half ? 2 : 4; }

  Result<TileHandle> tile(std::size_t index) {
    const std::scoped_lock lock(mutex);
    if (keys[index] == 0) return TileHandle();
    return store->get(keys[index]);
  }

  Status replace(std::size_t index, TileBytes bytes) {
    CUTIS_TRY(key, store->put(std::move(bytes)));
    const std::scoped_lock lock(mutex);
    const TileStore::Key old = std::exchange(keys[index], key);
    if (old != 0) store->remove(old);
    return {};
  }

  const int width;
  const int height;
  const int tilesAcross;
  const int tilesDown;
  const PixelFormat format;
  const std::shared_ptr<TileStore> store;
  std::mutex mutex;
  std::vector<TileStore::Key> keys;  // 0: zeros, not stored
};

namespace {

void decode(PixelFormat format, const std::byte* from, std::span<float> to) {
  if (format == PixelFormat::half) {
    convertHalfToFloat({reinterpret_cast<const std::uint16_t*>(from), to.size()}, to);
  } else {
    std::memcpy(to.data(), from, to.size_bytes());
  }
}

void encode(PixelFormat format, std::span<const float> from, std::byte* to) {
  if (format == PixelFormat::half) {
    convertFloatToHalf(from, {reinterpret_cast<std::uint16_t*>(to), from.size()});
  } else {
    std::memcpy(to, from.data(), from.size_bytes());
  }
}

Error outOfMemory() {
  return resourceError("", "not enough memory for the picture; use a smaller one");
}

std::size_t offsetIn(const Rect& rect, int x, int y) {
  return static_cast<std::size_t>(y - rect.y0) * static_cast<std::size_t>(rect.width()) +
         static_cast<std::size_t>(x - rect.x0);
}

// Calls visit(tile index, tile's rectangle, part of rect in that tile) for each tile touched.
template <typename Visit>
Status forEachTile(const Plane& plane, const Rect& rect, Visit visit) {
  if (rect.empty()) return {};
  constexpr int size = Plane::kTileSize;
  const int across = (plane.width() + size - 1) / size;
  for (int ty = rect.y0 / size; ty <= (rect.y1 - 1) / size; ++ty) {
    for (int tx = rect.x0 / size; tx <= (rect.x1 - 1) / size; ++tx) {
      const int index = ty * across + tx;
      const Rect tileRect = plane.tileRect(index);
      CUTIS_CHECK(visit(static_cast<std::size_t>(index), tileRect, intersection(rect, tileRect)));
    }
  }
  return {};
}

}  // namespace

Plane::Plane(int width, int height, PixelFormat format, std::shared_ptr<TileStore> store) {
  assert(width > 0 && height > 0);
  if (!store) store = std::make_shared<TileStore>();
  pixels_ = std::make_shared<Pixels>(width, height, format, std::move(store));
}

int Plane::width() const {
  return pixels_ ? pixels_->width : 0;
}
int Plane::height() const {
  return pixels_ ? pixels_->height : 0;
}
PixelFormat Plane::format() const {
  return pixels_ ? pixels_->format : PixelFormat::float32;
}
int Plane::tileCount() const {
  return pixels_ ? pixels_->tilesAcross * pixels_->tilesDown : 0;
}

Rect Plane::tileRect(int index) const {
  const int x0 = index % pixels_->tilesAcross * kTileSize;
  const int y0 = index / pixels_->tilesAcross * kTileSize;
  return intersection({x0, y0, x0 + kTileSize, y0 + kTileSize}, bounds());
}

Status Plane::load(const Rect& rect, std::span<float> out) const try {
  assert(out.size() == rect.pixelCount());
  return forEachTile(
      *this, rect, [&](std::size_t index, const Rect& tileRect, const Rect& part) -> Status {
        CUTIS_TRY(tile, pixels_->tile(index));
        const auto run = static_cast<std::size_t>(part.width());
        for (int y = part.y0; y < part.y1; ++y) {
          const std::span<float> row = out.subspan(offsetIn(rect, part.x0, y), run);
          if (!tile) {
            std::fill(row.begin(), row.end(), 0.0f);
            continue;
          }
          const std::size_t at = offsetIn(tileRect, part.x0, y) * pixels_->pixelBytes();
          decode(pixels_->format, tile->data() + at, row);
        }
        return {};
      });
} catch (const std::bad_alloc&) {
  // A tile that comes back from disk needs memory.
  return outOfMemory();
}

Status Plane::store(const Rect& rect, std::span<const float> in) try {
  assert(in.size() == rect.pixelCount());
  return forEachTile(
      *this, rect, [&](std::size_t index, const Rect& tileRect, const Rect& part) -> Status {
        TileBytes bytes(tileRect.pixelCount() * pixels_->pixelBytes());
        if (part != tileRect) {
          CUTIS_TRY(old, pixels_->tile(index));
          if (old) bytes = *old;
        }
        const auto run = static_cast<std::size_t>(part.width());
        for (int y = part.y0; y < part.y1; ++y) {
          const std::size_t at = offsetIn(tileRect, part.x0, y) * pixels_->pixelBytes();
          encode(pixels_->format, in.subspan(offsetIn(rect, part.x0, y), run), bytes.data() + at);
        }
        return pixels_->replace(index, std::move(bytes));
      });
} catch (const std::bad_alloc&) {
  return outOfMemory();
}

}  // namespace cutis
