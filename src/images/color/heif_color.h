#pragma once  // internal to src/images/color

// What a HEIC or AVIF file says of its colours: the properties colr of its primary picture, which
// OpenImageIO does not hand on (ISO/IEC 14496-12, §12.1.5, and 23008-12, §6.5).

#include <filesystem>
#include <optional>
#include <string>

#include "src/images/color/code_points.h"

namespace cutis {

struct HeifColors {
  std::optional<std::string> profile;  // the ICC profile
  // What nclx says of red, green and blue as they are decoded: full range, without a matrix.
  std::optional<CodePoints> codePoints;
};

// Boxes that are damaged or too large say nothing. Precondition: the file begins like a HEIC.
HeifColors readHeifColors(const std::filesystem::path& path);

}  // namespace cutis
