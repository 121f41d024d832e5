#pragma once

// What the header of a Radiance HDR file says of its samples, which OpenImageIO leaves unread
// (Ward, "Real Pixels", Graphics Gems II, 1991, and Radiance's filefmts).
//
// Thread-safe: a pure function of a file.

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace cutis {

struct RadianceHeader {
  // Samples have to be divided by it; all that the file states, multiplied.
  double exposure = 1.0;
  // x, y of red, green, blue and white.
  std::optional<std::array<double, 8>> primaries;
  std::string format;  // "32-bit_rle_rgbe"; empty where it is not stated
};

// Lines that are not understood are passed over; of a file that cannot be read nothing is known.
RadianceHeader readRadianceHeader(const std::filesystem::path& path);

}  // namespace cutis
