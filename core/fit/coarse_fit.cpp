#include "core/fit/coarse_fit.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/parallel.h"

namespace cutis {
namespace {

bool isToSolve(float state) {
  return pixelState(state) == PixelState::solved;
}

// The first pixel of every block of a tile.
struct BlockGrid {
  explicit BlockGrid(const Rect& tile)
      : rect(tile),
        columns(static_cast<std::size_t>((tile.width() + kCoarseBlock - 1) / kCoarseBlock)),
        rows(static_cast<std::size_t>((tile.height() + kCoarseBlock - 1) / kCoarseBlock)) {}

  Rect rect;
  std::size_t columns;
  std::size_t rows;

  std::size_t count() const { return columns * rows; }
  std::size_t blockOf(std::size_t pixel) const {
    const auto width = static_cast<std::size_t>(rect.width());
    return pixel / width / kCoarseBlock * columns + pixel % width / kCoarseBlock;
  }
};

// Appends the first pixel of each block; load(rect, values) reads a row of the tile.
template <typename Load>
Status loadFirstPixels(const Load& load, const BlockGrid& grid, std::vector<float>& values) {
  std::vector<float> line(static_cast<std::size_t>(grid.rect.width()));
  for (int y = grid.rect.y0; y < grid.rect.y1; y += kCoarseBlock) {
    CUTIS_CHECK(load(Rect{grid.rect.x0, y, grid.rect.x1, y + 1}, line));
    for (std::size_t c = 0; c < grid.columns; ++c)
      values.push_back(line[c * kCoarseBlock]);
  }
  return {};
}

// Values per block, and whether there are any.
struct BlockValues {
  PixelBuffer<float> found;  // a block in place of a pixel
  std::vector<char> known;
};

Result<BlockValues> solveBlocks(const Measurements& measurements, const PixelSolver& solver,
                                const BlockGrid& grid) {
  std::vector<float> states, loaded;
  const auto loadState = [&](const Rect& rect, std::span<float> row) {
    return measurements.state.load(rect, row);
  };
  CUTIS_CHECK(loadFirstPixels(loadState, grid, states));
  const std::size_t channelCount = measurements.channels.size();
  for (std::size_t k = 0; k < channelCount; ++k) {
    const auto loadChannel = [&](const Rect& rect, std::span<float> row) {
      return measurements.loadChannel(k, rect, row);
    };
    CUTIS_CHECK(loadFirstPixels(loadChannel, grid, loaded));
  }
  std::vector<std::size_t> blocks;
  std::vector<float> pixel(channelCount);
  for (std::size_t b = 0; b < grid.count(); ++b) {
    for (std::size_t k = 0; k < channelCount; ++k)
      pixel[k] = loaded[k * grid.count() + b];
    if (isToSolve(states[b]) && classify(pixel, 1.0f, false) == PixelState::solved) {
      blocks.push_back(b);
    }
  }
  PixelBuffer<float> channels(channelCount, blocks.size());
  PixelBuffer<float> found(solver.valueCount(), blocks.size());
  for (std::size_t k = 0; k < channelCount; ++k) {
    for (std::size_t i = 0; i < blocks.size(); ++i)
      channels[k][i] = loaded[k * grid.count() + blocks[i]];
  }
  std::vector<PixelState> solvedStates(blocks.size());
  std::vector<std::uint16_t> iterations(blocks.size());
  solver.solve(channels.rows(), found.rows(), {solvedStates.data(), iterations.data()});
  BlockValues values;
  values.found = PixelBuffer<float>(solver.valueCount(), grid.count());
  values.known.resize(grid.count(), 0);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    values.known[blocks[i]] = 1;
    for (std::size_t k = 0; k < found.rowCount(); ++k)
      values.found[k][blocks[i]] = found[k][i];
  }
  return values;
}

Status fillTile(const Measurements& measurements, const BlockGrid& grid, const BlockValues& values,
                ChromophoreMaps& maps) {
  std::vector<float> states(grid.rect.pixelCount()), plane(states.size());
  CUTIS_CHECK(measurements.state.load(grid.rect, states));
  // Nothing is known yet of a pixel whose block is not.
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (isToSolve(states[i]) && values.known[grid.blockOf(i)] == 0) {
      states[i] = storedState(PixelState::masked);
    }
  }
  std::vector<Plane> planes = maps.planes();
  for (std::size_t k = 0; k < planes.size(); ++k) {
    for (std::size_t i = 0; i < plane.size(); ++i)
      plane[i] = isToSolve(states[i]) ? values.found[k][grid.blockOf(i)] : 0.0f;
    CUTIS_CHECK(planes[k].store(grid.rect, plane));
  }
  return maps.state.store(grid.rect, states);
}

}  // namespace

Status runCoarseFit(const Measurements& measurements, const PixelSolver& solver,
                    ChromophoreMaps maps, const JobContext& context) {
  const auto tileCount = static_cast<std::size_t>(maps.state.tileCount());
  return parallelFor(tileCount, context, [&](std::size_t i) -> Status {
    const BlockGrid grid(maps.state.tileRect(static_cast<int>(i)));
    CUTIS_TRY(values, solveBlocks(measurements, solver, grid));
    return fillTile(measurements, grid, values, maps);
  });
}

}  // namespace cutis
