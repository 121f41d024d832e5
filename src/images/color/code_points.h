#pragma once  // internal to src/images/color

// Coding-independent code points of video (ITU-T H.273) and the interop identifiers of OpenEXR
// (Color Interop Forum) as colour spaces.

#include <optional>
#include <string>

#include "src/images/color/color_statement.h"

namespace cutis {

struct CodePoints {
  int primaries = 0;
  int transfer = 0;
  int matrix = 0;  // 0: red, green and blue themselves
  bool fullRange = true;
};

// What code points say of integers of so many bits: a cICP chunk of PNG, a box colr of HEIC. With
// an objection where they cannot be followed, and empty of both if they leave everything open.
ColorStatement statementOf(const CodePoints& points, int bits, const std::string& origin);

// Those that state a space exactly in integers of so many bits; nothing if none do.
std::optional<CodePoints> codePointsOf(const ColorSpace& space, int bits);

// The statement of the attribute colorInteropID, likewise.
ColorStatement statementOfInteropId(const std::string& id, const std::string& origin);

}  // namespace cutis
