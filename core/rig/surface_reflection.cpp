#include "core/rig/surface_reflection.h"

#include <cstddef>
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
  CUTIS_CHECK(parallelFor(
      static_cast<std::size_t>(state.tileCount()), context, [&](std::size_t i) -> Status {
        const Rect rect = state.tileRect(static_cast<int>(i));
        std::vector<float> values(rect.pixelCount());
        for (std::size_t k = 0; k < below.size(); ++k) {
          CUTIS_CHECK(measurements.channels[k].load(rect, values));
          for (float& value : values) {
            const auto channel = static_cast<float>(modelReflectance(geometry, double{value}));
            value = channel < 0.0f ? 0.0f : channel;
          }
          CUTIS_CHECK(below[k].store(rect, values));
        }
        return {};
      }));
  measurements.channels = std::move(below);
  measurements.rig.noise = noiseBelowSurface(measurements.rig.noise, geometry);
  return {};
}

}  // namespace cutis
