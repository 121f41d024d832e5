#pragma once

// What a file says of its colours, from its head.

#include <filesystem>

#include "src/images/codec/image_reader.h"
#include "src/images/color/color_statement.h"

namespace cutis {

// Precondition: the part is of the file.
FileColors fileColors(const std::filesystem::path& path, ImageFileKind kind, const ImagePart& part);

}  // namespace cutis
