#pragma once  // internal to src/images/color

// What a PNG file says of its colours, chunk by chunk, and the chunks that say it.
//
// libpng knows no cICP and drops profiles that it does not like, so that the chunks are read and
// written here (PNG, third edition, §11.3.2).

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "src/images/color/code_points.h"

namespace cutis {

struct PngColors {
  std::optional<CodePoints> cicp;
  std::optional<std::string> profile;  // the ICC profile of iCCP, empty if it is damaged
  bool hasSrgb = false;
  std::optional<double> gamma;  // of gAMA: the exponent from light to numbers
  // What cHRM says: x, y of red, green, blue and white.
  std::optional<std::array<double, 8>> chromaticities;
  std::string exif;  // content of eXIf
};

// Looks at the chunks before the pixels. Chunks of a wrong length do not count. Precondition: the
// chunks are whole (png_check.h).
PngColors readPngColors(const std::filesystem::path& path);

// Whole chunks, to be put behind IHDR.
std::string cicpChunk(const CodePoints& points);
std::string profileChunk(std::string_view profile);

}  // namespace cutis
