#pragma once

// What an output says of its colours: an ICC profile in JPEG, TIFF and PNG, chunks of PNG, EXIF
// and, in OpenEXR, chromaticities and our own attribute cutis:colorspace.

#include <string>

#include <OpenImageIO/imageio.h>

#include "src/color/color_space.h"
#include "src/images/codec/image_formats.h"

namespace cutis {

struct StatedColors {
  // Whether a reader will find the space again.
  bool complete = true;
  // What is to be put behind the head of the file: whole chunks behind IHDR of a PNG file, whole
  // segments behind the first one of a JPEG file.
  std::string inserted = {};
};

// Whether a file of this kind with colours in such samples can say that they are of this space.
bool canStateColors(ImageFileKind kind, SampleType type, const ColorSpace& space);

// Writes the statement into the header and takes out of it what is not true of this space. An empty
// space says nothing.
StatedColors stateColors(ImageFileKind kind, const ColorSpace& space, OIIO::ImageSpec& spec);

}  // namespace cutis
