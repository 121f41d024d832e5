#pragma once

// What pixels bring along beside the five parameters.

#include <optional>

#include "core/skin/profile/discrepancy.h"
#include "core/skin/profile/free_constants.h"
#include "core/skin/profile/profile.h"

namespace cutis {

struct PerPixel {
  FreeConstants free;
  // The coefficients of this discrepancy of the profile; not beside free constants.
  std::optional<SurfaceLight> discrepancy;

  bool operator==(const PerPixel&) const = default;
};

// Null where pixels bring no coefficients, or the profile does not know that discrepancy.
inline const Discrepancy* discrepancyOf(const Profile& profile, const PerPixel& perPixel) {
  return perPixel.discrepancy ? profile.discrepancies.of(*perPixel.discrepancy) : nullptr;
}

}  // namespace cutis
