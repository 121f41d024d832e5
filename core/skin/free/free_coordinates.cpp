#include "core/skin/free/free_coordinates.h"

#include <algorithm>
#include <cmath>

namespace cutis {

Result<FreeCoordinates> FreeCoordinates::make(const Profile& profile, const FreeConstants& free) {
  FreeCoordinates coordinates;
  coordinates.free_ = free;
  coordinates.own_ = constantsOf(profile);
  if (!free.thickness) return coordinates;
  CUTIS_TRY(range, thicknessRange(profile));
  coordinates.thickness_ = range;
  coordinates.logRange_ = std::log(range.highMm / range.lowMm);
  return coordinates;
}

int FreeCoordinates::indexOf(SkinConstant constant) const {
  if (!free_.has(constant)) return -1;
  return constant == kThickness && free_.oxygenation ? 1 : 0;
}

SkinConstants FreeCoordinates::constantsAt(const double* coordinates) const {
  SkinConstants constants = own_;
  if (free_.oxygenation) constants.oxygenation = std::clamp(coordinates[0], 0.0, 1.0);
  if (free_.thickness) {
    const double thickness =
        thickness_.lowMm * std::exp(logRange_ * coordinates[indexOf(kThickness)]);
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

void FreeCoordinates::coordinatesOf(const SkinConstants& constants, double* coordinates) const {
  if (free_.oxygenation) coordinates[0] = std::clamp(constants.oxygenation, 0.0, 1.0);
  if (free_.thickness) {
    const double share = std::log(constants.thicknessMm / thickness_.lowMm) / logRange_;
    coordinates[indexOf(kThickness)] = std::clamp(share, 0.0, 1.0);
  }
}

double FreeCoordinates::slope(SkinConstant constant, const SkinConstants& at) const {
  return constant == kOxygenation ? 1.0 : at.thicknessMm * logRange_;
}

}  // namespace cutis
