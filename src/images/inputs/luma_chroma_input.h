#pragma once

// OpenEXR files of luminance and chroma, which OpenImageIO does not read because their chroma has
// fewer samples (channels Y, RY and BY).

#include <filesystem>

#include <OpenImageIO/imageio.h>

namespace cutis {

// R, G, B and, where the file has one, A, as halves, made by OpenEXR's own reconstruction. Null if
// the file is none of these; throws what OpenEXR throws.
OIIO::ImageInput::unique_ptr openLumaChroma(const std::filesystem::path& path);

}  // namespace cutis
