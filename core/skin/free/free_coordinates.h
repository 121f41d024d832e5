#pragma once  // internal to core/skin/free

// Free constants as coordinates from 0 to 1: the oxygenation is one as it is; that of the thickness
// is how far its logarithm is on the way through thicknessRange().
//
// Thread-safe: const after construction.

#include "core/base/result.h"
#include "core/skin/profile/free_constants.h"

namespace cutis {

class FreeCoordinates {
 public:
  // Error: that of thicknessRange() where the thickness is free. Precondition: the profile is
  // valid.
  static Result<FreeCoordinates> make(const Profile& profile, const FreeConstants& free);

  const FreeConstants& free() const { return free_; }
  int count() const { return free_.count(); }
  // Where a constant stands among the free ones; −1 if it is not free.
  int indexOf(SkinConstant constant) const;
  // The profile's own constants.
  const SkinConstants& own() const { return own_; }
  const ThicknessRange& thickness() const { return thickness_; }

  // coordinates: count() of them, 0 to 1; what is not free is the profile's. Always within the
  // ranges.
  SkinConstants constantsAt(const double* coordinates) const;
  // The nearest constants within the ranges; what is not free is the profile's.
  SkinConstants clamped(const SkinConstants& constants) const;
  // Clamped into 0 to 1.
  void coordinatesOf(const SkinConstants& constants, double* coordinates) const;

  // The derivative of a constant by its place, at these constants.
  double slope(SkinConstant constant, const SkinConstants& at) const;

 private:
  FreeConstants free_;
  SkinConstants own_;
  ThicknessRange thickness_;
  double logRange_ = 0.0;  // of the thickness
};

}  // namespace cutis
