#pragma once

// What a file says of its colours. For the files of this folder.

#include <string>

#include <OpenImageIO/imageio.h>

#include "src/images/codec/sample_type.h"
#include "src/images/codec/source_file.h"

namespace cutis {

// The name of the file's colour space as src/color understands it: from our own attribute, the ICC
// profile's description, the primaries of an EXR, the PNG and EXIF tags. Empty if the file says
// nothing; OpenImageIO's guesses do not count. "unknown primaries" if an EXR has some of its own.
std::string colorSpaceOf(ImageFileKind kind, const OIIO::ImageSpec& spec);

// Writes the name into the file the way its format knows; whether a reader will find it again.
bool tagColorSpace(ImageFileKind kind, SampleType type, const std::string& name,
                   OIIO::ImageSpec& spec);

}  // namespace cutis
