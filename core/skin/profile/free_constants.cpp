#include "core/skin/profile/free_constants.h"

#include <algorithm>
#include <string>

#include "core/skin/profile/absorption.h"

namespace cutis {

std::string_view constantName(SkinConstant constant) {
  return constant == kOxygenation ? "oxygenation" : "thickness_mm";
}

std::vector<std::string> constantNames(const FreeConstants& free) {
  std::vector<std::string> names;
  for (const SkinConstant constant : kSkinConstants) {
    if (free.has(constant)) names.emplace_back(constantName(constant));
  }
  return names;
}

bool isPossible(SkinConstant constant, double value) {
  constexpr double kMore = 1.001;
  if (constant == kOxygenation) return value >= 0.0 && value <= kMore;
  return value >= kThinnestMm / kMore && value <= kThickestMm * kMore;
}

SkinConstants constantsOf(const Profile& profile) {
  return {profile.dermalBlood.oxygenation, profile.epidermalThicknessMm};
}

double epidermalOxygenation(const Profile& profile, double dermalOxygenation) {
  const double own = profile.dermalBlood.oxygenation;
  // To the bit where nothing is moved.
  if (dermalOxygenation == own) return profile.epidermalBlood.oxygenation;
  return std::clamp(dermalOxygenation + (profile.epidermalBlood.oxygenation - own), 0.0, 1.0);
}

Profile withConstants(const Profile& profile, const SkinConstants& constants) {
  Profile changed = profile;
  changed.epidermalBlood.oxygenation = epidermalOxygenation(profile, constants.oxygenation);
  changed.dermalBlood.oxygenation = constants.oxygenation;
  changed.epidermalThicknessMm = constants.thicknessMm;
  return changed;
}

Result<ThicknessRange> thicknessRange(const Profile& profile) {
  ThicknessRange range;
  if (profile.layerOptics == LayerOpticsKind::diffusion) {
    range.lowMm = std::max(range.lowMm, longestPathMm(profile));
  }
  const double own = profile.epidermalThicknessMm;
  if (own >= range.lowMm && own <= range.highMm) return range;
  return inputError(profile.name, "its epidermis of " + std::to_string(own) +
                                      " mm lies outside 0.02 to 0.5 mm, where a thickness can be "
                                      "looked for; keep the thickness of this profile");
}

}  // namespace cutis
