#pragma once  // internal to src/images/color

// Coding-independent code points of video (ITU-T H.273) and the interop identifiers of OpenEXR
// (Color Interop Forum) as colour spaces.

#include <string>

#include "src/images/color/color_statement.h"
#include "src/images/color/png_color.h"

namespace cutis {

// The statement of a cICP chunk; with an objection where it cannot be followed, and empty of both
// if it leaves everything open.
ColorStatement statementOf(const PngColors::CodePoints& points, const std::string& origin);

// The statement of the attribute colorInteropID, likewise.
ColorStatement statementOfInteropId(const std::string& id, const std::string& origin);

}  // namespace cutis
