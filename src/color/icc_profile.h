#pragma once

// ICC profiles, by their own curves and matrix or table, through LittleCMS.
//
// The relative colorimetric intent, without black point compensation: the profile's white is white.
// A profile with a table is followed by the table, as the standard demands; its way back is the
// numerical inverse of the same table. Errors say
// why it cannot be used, as a clause: "it is cut off". Thread-safe.

#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "src/color/color_space.h"

namespace cutis {

// Larger ones are taken for damaged.
inline constexpr std::size_t kLargestProfileBytes = std::size_t{1} << 24;

// What the pixels of a file must be for its profile to describe them.
enum class ProfileKind { rgb, grey, cmyk, lab };

struct IccProfile {
  ProfileKind kind = ProfileKind::rgb;
  std::string description;  // its name, for people; may be empty
  // The space of RGB, and of grey as R = G = B; empty for the others. Carries the profile's bytes,
  // for grey those of an RGB profile of the same curve.
  ColorSpace space;
  // For CMYK alone: inks from 0 (none) to 1, four a pixel, to linear Rec.709.
  std::function<void(std::span<const float> inks, std::span<float> rgb)> inksToLinearRec709;
};

Result<IccProfile> readIccProfile(std::string_view bytes, const std::string& place);

// An ICC profile (version 4) of a space of curves and a matrix; empty for any other, and for curves
// that profiles do not have (PQ, HLG). The same bytes for the same space.
std::string iccProfileOf(const ColorSpace& space);

}  // namespace cutis
