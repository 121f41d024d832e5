#pragma once

// JPEG files of inks (CMYK, also stored as YCCK), which OpenImageIO makes red, green and blue of,
// without asking the file's ICC profile.
//
// libjpeg decodes them here. Files with Adobe's marker count inks from 255 (none) to 0, as
// Photoshop and all that follows it write them; they are turned round.

#include <filesystem>

#include <OpenImageIO/imageio.h>

namespace cutis {

// Whether a JPEG file stores inks, by the head that OpenImageIO reads.
bool isInkJpeg(const OIIO::ImageSpec& head);

// Channels C, M, Y and K from 0 (no ink) to 255, row by row, with what else OpenImageIO found in
// the head. What libjpeg does not like becomes the input's error, warnings as well.
OIIO::ImageInput::unique_ptr openInkJpeg(const std::filesystem::path& path,
                                         const OIIO::ImageSpec& head);

}  // namespace cutis
