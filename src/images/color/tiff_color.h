#pragma once  // internal to src/images/color

// What the tags of a TIFF file say of its colours besides an ICC profile: PrimaryChromaticities,
// WhitePoint and TransferFunction (TIFF 6.0, §20).
//
// Where one of them is there, what the others leave open is assumed, and said: the primaries of
// Rec.709, a white of D65, and the usual curve of the samples. WhitePoint alone says nothing, since
// white stays white.

#include <filesystem>

#include "src/color/color_space.h"
#include "src/images/color/color_statement.h"

namespace cutis {

// `usual`: of the samples without a statement, sRGB or linear. Empty of both space and objection if
// the file says nothing. Precondition: it begins like a TIFF.
ColorStatement tiffTagStatement(const std::filesystem::path& path, const TransferCurve& usual);

}  // namespace cutis
