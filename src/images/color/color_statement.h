#pragma once

// What a file says of its colours, and which of its statements is followed.
//
// A file may say several things, which count in this order; the first that says something decides:
//
//   1. the choice of the user (--colorspace, the dialog)
//   2. how the pixels are stored: CIELab, inks (CMYK), luminance and chroma
//   3. OpenEXR: our own attribute cutis:colorspace
//   4. PNG: cICP, iCCP, sRGB, gAMA with cHRM
//      JPEG, PSD, WebP: the ICC profile
//      TIFF: the ICC profile, PrimaryChromaticities with WhitePoint and TransferFunction
//      HEIC: the ICC profile, the code points (nclx)
//      OpenEXR: chromaticities, colorInteropID, acesImageContainerFlag
//   5. EXIF in integers: ColorSpace and InteroperabilityIndex (1: sRGB; 65535 and R03: Adobe RGB)
//   6. the default: sRGB in integers, linear Rec.709 in floats
//
// An ICC profile is followed by its own curves and matrix or table and never by its name. All of
// this is known from the head of a file, without any pixel. Values; threads may read them.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "src/color/color_space.h"

namespace cutis {

enum class ColorSource {
  choice,
  storage,
  ownAttribute,
  codePoints,
  iccProfile,
  tiffTags,
  srgbChunk,
  gammaChunk,
  chromaticities,
  interopId,
  acesContainer,
  exif,
  formatDefault,
};

struct ColorStatement {
  ColorSource source = ColorSource::formatDefault;
  // "its cICP chunk", "its ICC profile 'studio'", "EXIF"
  std::string origin;
  // Empty if the statement cannot be followed.
  ColorSpace space;
  // Then why, as a clause about the origin: "is for grey pixels, but the picture is in colour". Of
  // storage: how the pixels are stored.
  std::string objection = {};
  // What was taken for granted to follow it, "light of 203 cd/m² is taken as 1"; may be empty.
  std::string assumption = {};

  // What it says, for lists: the name of the space and the assumption, else the objection.
  std::string meaning() const;
};

struct FileColors {
  // In the order in which they count.
  std::vector<ColorStatement> statements;
  // Taken if the file says nothing.
  ColorStatement byDefault;
  // Pixels are converted while they are read (CIELab, inks, luminance and chroma): R, G and B are
  // linear Rec.709, and not what the file stores.
  bool isConverted = false;

  // The name of the space that counts first; empty if the file says nothing that can be followed.
  std::string stated() const { return statements.empty() ? "" : statements.front().space.name; }
};

struct ColorDecision {
  ColorStatement followed;
  // "its colours are read as Display P3, according to its cICP chunk", with the assumption behind a
  // semicolon.
  std::string sentence;
  // A sentence for each statement that says something else.
  std::vector<std::string> contradictions;
};

// `choice` is a name, empty for none; `place` names the file in errors. Fails for a choice that is
// unknown or cannot apply, and if the first statement cannot be followed.
Result<ColorDecision> decideColors(const FileColors& file, const std::string& choice,
                                   const std::string& place);

}  // namespace cutis
