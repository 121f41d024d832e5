#include "core/simulate/skin_patch.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/simulate/paint/patch_painter.h"
#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

// 0 where there is no skin; elsewhere within the axes.
void limit(const std::vector<float>& mask, const ParameterAxes& axes, PatchTile& tile) {
  for (std::size_t k = 0; k < tile.values.size(); ++k) {
    const auto maximum = static_cast<float>(axes[k].maximum);
    std::vector<float>& values = tile.values[k];
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = mask[i] > 0.0f ? std::clamp(values[i], 0.0f, maximum) : 0.0f;
    }
  }
}

Status paintInto(SimulatedSkin& skin, const PatchPainter& painter, const ParameterAxes& axes,
                 const Rect& rect) {
  const std::vector<float> mask = painter.mask(rect);
  std::vector<float> states;
  states.reserve(mask.size());
  for (const float inside : mask) {
    states.push_back(storedState(inside > 0.0f ? PixelState::solved : PixelState::masked));
  }
  PatchTile tile = painter.paint(rect);
  limit(mask, axes, tile);
  for (std::size_t k = 0; k < tile.values.size(); ++k) {
    CUTIS_CHECK(skin.maps.values[k].store(rect, tile.values[k]));
  }
  CUTIS_CHECK(skin.maps.state.store(rect, states));
  return skin.mask.store(rect, mask);
}

}  // namespace

Result<SimulatedSkin> simulateSkin(const SkinRecipe& recipe, int width, int height,
                                   std::uint64_t seed, const ParameterAxes& axes,
                                   const std::shared_ptr<TileStore>& store,
                                   const JobContext& context) {
  if (std::min(width, height) < 1 || std::max(width, height) > kLargestPatch) {
    return usageError("", "a patch cannot be " + std::to_string(width) + " × " +
                              std::to_string(height) + " pixels; choose 1 to " +
                              std::to_string(kLargestPatch) + " each way");
  }
  CUTIS_CHECK(validate(recipe, "recipe"));
  SimulatedSkin skin;
  skin.maps = ChromophoreMaps(width, height, PixelFormat::float32, store);
  skin.mask = Plane(width, height, PixelFormat::half, store);
  const PatchPainter painter(recipe, {width, height}, seed);
  CUTIS_CHECK(
      parallelFor(static_cast<std::size_t>(skin.mask.tileCount()), context, [&](std::size_t i) {
        return paintInto(skin, painter, axes, skin.mask.tileRect(static_cast<int>(i)));
      }));
  return skin;
}

}  // namespace cutis
