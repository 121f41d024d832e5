#include "core/rig/surface_reflection.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/parallel.h"

namespace cutis {

NoiseModel noiseBelowSurface(const NoiseModel& noise, const MeasurementGeometry& geometry) {
  if (geometry.specularShare == 0.0) return noise;
  return {noise.read / geometry.enteringShare, noise.proportional,
          noise.veil + geometry.specularShare / geometry.enteringShare};
}

Status removeSurfaceReflection(const MeasurementGeometry& geometry,
                               const std::shared_ptr<TileStore>& store, const JobContext& context,
                               Measurements& measurements) {
  if (geometry.specularShare == 0.0) return {};
  std::vector<Plane> below;
  for (std::size_t k = 0; k < measurements.channels.size(); ++k)
    below.emplace_back(measurements.width(), measurements.height(), PixelFormat::float32, store);
  const Plane& state = measurements.state;
  std::atomic<std::uint64_t> there = 0, dark = 0;
  CUTIS_CHECK(parallelFor(
      static_cast<std::size_t>(state.tileCount()), context, [&](std::size_t i) -> Status {
        const Rect rect = state.tileRect(static_cast<int>(i));
        std::vector<float> values(rect.pixelCount()), states(rect.pixelCount());
        CUTIS_CHECK(state.load(rect, states));
        std::vector<bool> isDark(rect.pixelCount(), false);
        for (std::size_t k = 0; k < below.size(); ++k) {
          CUTIS_CHECK(measurements.channels[k].load(rect, values));
          for (std::size_t p = 0; p < values.size(); ++p) {
            const auto channel = static_cast<float>(modelReflectance(geometry, double{values[p]}));
            values[p] = channel < 0.0f ? 0.0f : channel;
            if (channel < 0.0f) isDark[p] = true;
          }
          CUTIS_CHECK(below[k].store(rect, values));
        }
        for (std::size_t p = 0; p < states.size(); ++p) {
          if (pixelState(states[p]) != PixelState::solved) continue;
          ++there;
          if (isDark[p]) ++dark;
        }
        return {};
      }));
  if (100 * dark > there) {
    context.say(std::to_string(100 * dark / there) +
                " % of the pixels are darker than the reflection of the surface that was taken off "
                "them; give a smaller specular share");
  }
  measurements.channels = std::move(below);
  measurements.rig.noise = noiseBelowSurface(measurements.rig.noise, geometry);
  return {};
}

}  // namespace cutis
