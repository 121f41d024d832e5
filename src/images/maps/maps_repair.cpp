#include "src/images/maps/maps_repair.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/skin/pixel_state.h"
#include "core/skin/profile/parameter.h"

namespace cutis {
namespace {

struct Tile {
  std::vector<float> state;
  std::vector<std::vector<float>> values;  // parameters, then constants
  FreeConstants free;

  Status load(const ChromophoreMaps& maps, const Rect& rect) {
    state.resize(rect.pixelCount());
    CUTIS_CHECK(maps.state.load(rect, state));
    free = maps.free();
    for (const Plane& plane : maps.planes()) {
      values.emplace_back(rect.pixelCount());
      CUTIS_CHECK(plane.load(rect, values.back()));
    }
    return {};
  }

  Status store(ChromophoreMaps& maps, const Rect& rect) const {
    std::vector<Plane> planes = maps.planes();
    for (std::size_t k = 0; k < values.size(); ++k) {
      CUTIS_CHECK(planes[k].store(rect, values[k]));
    }
    return maps.state.store(rect, state);
  }

  bool hasPossibleConstants(std::size_t p) const {
    std::size_t next = kParameterCount;
    for (const SkinConstant constant : kSkinConstants) {
      if (free.has(constant) && !isPossible(constant, double{values[next++][p]})) return false;
    }
    return true;
  }

  std::size_t invalidateSpoiled() {
    std::size_t spoiled = 0;
    for (std::size_t p = 0; p < state.size(); ++p) {
      const bool finite = std::all_of(values.begin(), values.end(),
                                      [&](const auto& v) { return std::isfinite(v[p]); });
      const bool sound = finite && isPixelState(state[p]);
      if (sound && (!hasEstimate(pixelState(state[p])) || hasPossibleConstants(p))) continue;
      ++spoiled;
      state[p] = storedState(PixelState::invalid);
      for (auto& v : values)
        v[p] = 0.0f;
    }
    return spoiled;
  }

  void maskOutside(const Rect& stored, const Rect& rect) {
    std::size_t p = 0;
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x, ++p) {
        if (stored.contains(x, y)) continue;
        state[p] = storedState(PixelState::masked);
        for (auto& v : values)
          v[p] = 0.0f;
      }
    }
  }
};

}  // namespace

Result<std::size_t> invalidateSpoiledPixels(ChromophoreMaps& maps, const JobContext& context) {
  std::atomic<std::size_t> total = 0;
  const auto tiles = static_cast<std::size_t>(maps.state.tileCount());
  const auto repair = [&](std::size_t i) -> Status {
    const Rect rect = maps.state.tileRect(static_cast<int>(i));
    Tile tile;
    CUTIS_CHECK(tile.load(maps, rect));
    const std::size_t spoiled = tile.invalidateSpoiled();
    if (spoiled == 0) return {};
    total += spoiled;
    return tile.store(maps, rect);
  };
  CUTIS_CHECK(parallelFor(tiles, {context.stop, {}, {}}, repair));
  return total.load();
}

Status maskOutside(const Rect& stored, ChromophoreMaps& maps, const JobContext& context) {
  const auto tiles = static_cast<std::size_t>(maps.state.tileCount());
  return parallelFor(tiles, {context.stop, {}, {}}, [&](std::size_t i) -> Status {
    const Rect rect = maps.state.tileRect(static_cast<int>(i));
    if (intersection(rect, stored) == rect) return {};
    Tile tile;
    CUTIS_CHECK(tile.load(maps, rect));
    tile.maskOutside(stored, rect);
    return tile.store(maps, rect);
  });
}

Status zeroWhereNotFinite(Plane& plane, const JobContext& context) {
  const auto tiles = static_cast<std::size_t>(plane.tileCount());
  return parallelFor(tiles, {context.stop, {}, {}}, [&](std::size_t i) -> Status {
    const Rect rect = plane.tileRect(static_cast<int>(i));
    std::vector<float> values(rect.pixelCount());
    CUTIS_CHECK(plane.load(rect, values));
    const auto spoiled = [](float v) { return !std::isfinite(v); };
    if (std::none_of(values.begin(), values.end(), spoiled)) return {};
    std::replace_if(values.begin(), values.end(), spoiled, 0.0f);
    return plane.store(rect, values);
  });
}

}  // namespace cutis
