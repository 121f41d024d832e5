#pragma once  // internal to src/images/codec

// Pixels that are not stored as R, G and B: CIELab and inks in TIFF files, inks in JPEG files.
//
// They are converted while they are read, to linear Rec.709 in floats without limits, because no
// other part of the program knows them. CIELab is under D50, as ICC profiles and photo editors take
// it; inks are CMYK by the file's ICC profile.

#include <functional>
#include <optional>
#include <span>
#include <string>

#include <OpenImageIO/imageio.h>

#include "src/images/codec/source_file.h"

namespace cutis {

struct StoredColors {
  // "CIELab", "CMYK with the ICC profile 'press'"
  std::string name;
  int channels = 3;  // that are converted, the first ones
  // Samples as they are read, integers from 0 to 1, to linear Rec.709; any number of threads.
  // Empty if it cannot be done.
  std::function<void(std::span<const float> stored, std::span<float> rgb)> toLinearRec709;
  // Then why.
  std::string objection;
};

// Whether OpenImageIO has to be asked for pixels as they are stored, which it else makes 8-bit RGB
// of, without a profile. For the files of this folder.
bool needsRawColors(ImageFileKind kind, const OIIO::ImageSpec& spec);

// OpenImageIO calls the samples of a grey TIFF R and G where no tag says what the second one is:
// Y, and a channel that nothing explains.
void nameUndeclared(ImageFileKind kind, OIIO::ImageSpec& spec);

// Nothing for the usual kinds. The spec is that of pixels as they are stored.
std::optional<StoredColors> storedColorsOf(ImageFileKind kind, const OIIO::ImageSpec& spec,
                                           const std::string& place);

// The bytes of the file's ICC profile; empty without one.
std::string_view iccProfileBytes(const OIIO::ImageSpec& spec);

}  // namespace cutis
