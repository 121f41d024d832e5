#pragma once  // internal to src/images/preview

// Smaller versions of a picture beside it in its file: levels of an OpenEXR file, pages of a TIFF
// file that say they are such.

#include <optional>

#include "src/images/codec/image_reader.h"

namespace cutis {

struct SmallerVersion {
  ImagePart part;
  int reduction = 2;  // a pixel stands for reduction × reduction of the picture
};

// The smallest whose longer side still has as many pixels; nothing if there is none.
std::optional<SmallerVersion> smallerVersion(ImageReader& reader, const ImagePart& part,
                                             int leastSide);

}  // namespace cutis
