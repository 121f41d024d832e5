#pragma once  // internal to src/images/color

// What a WebP file says of its colours: the chunks ICCP and EXIF, which OpenImageIO does not hand
// on (WebP container specification, "Extended File Format").

#include <filesystem>
#include <optional>
#include <string>

namespace cutis {

struct WebPColors {
  std::optional<std::string> profile;  // the ICC profile
  std::string exif;                    // the EXIF block, a TIFF structure
};

// Chunks that are cut off or too large are not there. Precondition: the file begins like a WebP.
WebPColors readWebPColors(const std::filesystem::path& path);

}  // namespace cutis
