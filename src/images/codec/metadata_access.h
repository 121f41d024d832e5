#pragma once

// Metadata from and to OpenImageIO. For the files of this folder.

#include <OpenImageIO/imageio.h>

#include "src/images/codec/metadata.h"

namespace cutis {

struct MetadataAccess {
  // Leaves out what describes storage, what a writer of EXR reserves, and single values too large
  // for a header.
  static ImageMetadata from(const OIIO::ImageSpec& spec);
  // libpng refuses a profile whose illuminant is not D50 to the last digit, and says so on stderr.
  static bool pngTakesProfile(const ImageMetadata& metadata);
  // The colour profile goes along only if the pixels still are what it describes.
  static void add(const ImageMetadata& metadata, bool withColorProfile, OIIO::ImageSpec& spec);
};

}  // namespace cutis
