#include "core/skin/free/free_coordinates.h"

#include <algorithm>
#include <cmath>

namespace cutis {

Result<FreeCoordinates> FreeCoordinates::make(const Profile& profile, const FreeConstants& free) {
  FreeCoordinates places;
  places.free_ = free;
  places.own_ = constantsOf(profile);
  if (!free.thickness) return places;
  CUTIS_TRY(range, thicknessRange(profile));
  places.thickness_ = range;
  places.logRange_ = std::log(range.highMm / range.lowMm);
  return places;
}

int FreeCoordinates::indexOf(SkinConstant constant) const {
  if (!free_.has(constant)) return -1;
  return constant == kThickness && free_.oxygenation ? 1 : 0;
}

SkinConstants FreeCoordinates::at(const double* places) const {
  SkinConstants constants = own_;
  if (free_.oxygenation) constants.oxygenation = std::clamp(places[0], 0.0, 1.0);
  if (free_.thickness) {
    const double thickness = thickness_.lowMm * std::exp(logRange_ * places[indexOf(kThickness)]);
    constants.thicknessMm = std::clamp(thickness, thickness_.lowMm, thickness_.highMm);
  }
  return constants;
}

SkinConstants FreeCoordinates::clamped(const SkinConstants& constants) const {
  SkinConstants nearest = own_;
  if (free_.oxygenation) nearest.oxygenation = std::clamp(constants.oxygenation, 0.0, 1.0);
  if (free_.thickness) {
    nearest.thicknessMm = std::clamp(constants.thicknessMm, thickness_.lowMm, thickness_.highMm);
  }
  return nearest;
}

void FreeCoordinates::placesOf(const SkinConstants& constants, double* places) const {
  if (free_.oxygenation) places[0] = std::clamp(constants.oxygenation, 0.0, 1.0);
  if (free_.thickness) {
    const double place = std::log(constants.thicknessMm / thickness_.lowMm) / logRange_;
    places[indexOf(kThickness)] = std::clamp(place, 0.0, 1.0);
  }
}

double FreeCoordinates::slope(SkinConstant constant, const SkinConstants& at) const {
  return constant == kOxygenation ? 1.0 : at.thicknessMm * logRange_;
}

}  // namespace cutis
