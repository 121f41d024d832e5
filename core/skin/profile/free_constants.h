#pragma once

// Two constants of a profile that a measurement with enough wavelengths may decide instead: the
// oxygenation of blood and the thickness of the epidermis.
//
// Thread-safe: pure functions.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/skin/profile/profile.h"

namespace cutis {

// In this order wherever both are listed.
enum SkinConstant : int { kOxygenation, kThickness };
inline constexpr int kConstantCount = 2;
inline constexpr std::array<SkinConstant, kConstantCount> kSkinConstants = {kOxygenation,
                                                                            kThickness};

// "oxygenation", "thickness_mm".
std::string_view constantName(SkinConstant constant);

// Which of them are free.
struct FreeConstants {
  bool oxygenation = false;
  bool thickness = false;

  int count() const { return int{oxygenation} + int{thickness}; }
  bool has(SkinConstant constant) const {
    return constant == kOxygenation ? oxygenation : thickness;
  }
  bool operator==(const FreeConstants&) const = default;
};

// Of those that are free.
std::vector<std::string> constantNames(const FreeConstants& free);

struct SkinConstants {
  double oxygenation = 0.0;  // γ of the dermis, 0 to 1
  double thicknessMm = 0.0;  // of the epidermis

  double& operator[](SkinConstant constant) {
    return constant == kOxygenation ? oxygenation : thicknessMm;
  }
  double operator[](SkinConstant constant) const {
    return constant == kOxygenation ? oxygenation : thicknessMm;
  }
};

SkinConstants constantsOf(const Profile& profile);

// The blood of the epidermis keeps its difference in oxygenation to that of the dermis, as far as 0
// to 1 allows.
double epidermalOxygenation(const Profile& profile, double dermalOxygenation);

// The profile with these constants in place of its own.
Profile withConstants(const Profile& profile, const SkinConstants& constants);

// What radiative transfer is tabulated for within its stated error (core/skin/layers/table.h).
inline constexpr double kThinnestMm = 0.02;
inline constexpr double kThickestMm = 0.5;

// Whether some profile could have this value of a constant, give or take a thousandth for values
// that were stored in few bits. NaN: no.
bool isPossible(SkinConstant constant, double value);

struct ThicknessRange {
  double lowMm = kThinnestMm;
  double highMm = kThickestMm;
};

// Thicknesses that may be looked for: kThinnestMm to kThickestMm, for diffusion not below what
// validate(profile) asks for. Error: the profile's own lies outside. Precondition: the profile is
// valid.
Result<ThicknessRange> thicknessRange(const Profile& profile);

}  // namespace cutis
