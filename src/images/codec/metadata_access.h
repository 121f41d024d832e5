#pragma once

// Metadata from and to OpenImageIO. For the files of this folder.

#include <OpenImageIO/imageio.h>

#include "src/images/codec/metadata.h"

namespace cutis {

struct MetadataAccess {
  // Leaves out what describes storage, what a writer of EXR reserves, and single values too large
  // for a header.
  static ImageMetadata from(const OIIO::ImageSpec& spec);
  static void add(const ImageMetadata& metadata, OIIO::ImageSpec& spec);
};

}  // namespace cutis
