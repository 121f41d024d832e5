#include "core/skin/chromophore_maps.h"

namespace cutis {

ChromophoreMaps::ChromophoreMaps(int width, int height, PixelFormat format,
                                 const std::shared_ptr<TileStore>& store, const FreeConstants& free)
    : state(width, height, PixelFormat::half, store) {
  for (Plane& plane : values)
    plane = Plane(width, height, format, store);
  for (const SkinConstant constant : kSkinConstants) {
    if (free.has(constant)) constants[constant] = Plane(width, height, format, store);
  }
}

std::vector<Plane> ChromophoreMaps::planes() const {
  std::vector<Plane> all(values.begin(), values.end());
  for (const Plane& plane : constants) {
    if (!plane.empty()) all.push_back(plane);
  }
  all.insert(all.end(), coefficients.begin(), coefficients.end());
  return all;
}

PerPixel ChromophoreMaps::perPixel() const {
  if (coefficients.empty()) return {free(), std::nullopt};
  return {free(), surface};
}

void ChromophoreMaps::addCoefficients(SurfaceLight of, int count,
                                      const std::shared_ptr<TileStore>& store) {
  surface = of;
  for (int c = 0; c < count; ++c)
    coefficients.emplace_back(width(), height(), PixelFormat::half, store);
}

Status checkCoefficients(const ChromophoreMaps& maps, const Profile& profile,
                         const std::string& place) {
  const PerPixel perPixel = maps.perPixel();
  if (!perPixel.discrepancy) return {};
  const Discrepancy* known = discrepancyOf(profile, perPixel);
  if (known != nullptr && known->count() == static_cast<int>(maps.coefficients.size())) return {};
  return inputError(place, "the maps hold " + std::to_string(maps.coefficients.size()) +
                               " coefficients of a discrepancy that their profile does not have; "
                               "fit the image again");
}

}  // namespace cutis
