#pragma once

// Colour spaces by name, to and from linear Rec.709.
//
// Known without any file: sRGB, Linear Rec.709, ACEScg, ACES2065-1, Linear Rec.2020, Linear P3-D65,
// Display P3, Adobe RGB (1998), Gamma 2.2 Rec.709 and Raw (numbers taken as they are). Case, blanks
// and separators do not matter, and the names other programs give them are understood (lin_rec709,
// lin_srgb, linear, lin_ap1, …). If $OCIO names an OpenColorIO configuration, its colour spaces,
// aliases and roles are found too; the names above always mean what they mean here.
//
// White stays white: spaces with another white point are adapted (Bradford). Values below 0 and
// above 1 are carried through; transfer curves continue oddly below 0. NaN in a channel gives NaN
// in that pixel. Matrices and curves are those of the standards to within float rounding.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace cutis {

// Converts interleaved R, G, B in place; the size is a multiple of 3. Any number of threads may
// call one converter at once. Fails only if a configuration's own transform does.
using ColorConverter = std::function<Status(std::span<float> rgb)>;

// `place` stands in front of an error about the name: "--colorspace", "face.exr".
Result<ColorConverter> toLinearRec709(const std::string& name, const std::string& place);
Result<ColorConverter> fromLinearRec709(const std::string& name, const std::string& place);

// The one spelling of a name that is shown to people and written to files.
Result<std::string> canonicalColorSpace(const std::string& name, const std::string& place);

// What may be offered for choice: the spaces above, then those of $OCIO if it can be read.
std::vector<std::string> colorSpaceNames();

}  // namespace cutis
