#pragma once

// The chunks of a WebP file that OpenImageIO does not hand on (WebP container specification,
// "Extended File Format").

#include <filesystem>
#include <optional>
#include <string>

namespace cutis {

struct WebPChunks {
  std::optional<std::string> profile;  // the ICC profile
  std::string exif;                    // the EXIF block, a TIFF structure
  int frames = 0;                      // of an animation
};

// Chunks that are cut off or too large are not there. Precondition: the file begins like a WebP.
WebPChunks readWebPChunks(const std::filesystem::path& path);

}  // namespace cutis
