#pragma once  // internal to src/images/color

// What EXIF says of the colours: ColorSpace and InteroperabilityIndex, of which OpenImageIO reads
// only the first (Exif 2.32, §4.6.5 and §4.6.7).

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

namespace cutis {

struct ExifColors {
  std::optional<int> colorSpace;  // 1: sRGB; 65535: none of EXIF's own
  std::string interopIndex;       // "R98": sRGB, "R03": Adobe RGB
};

// What a TIFF structure says that begins at the beginning of the stream: a TIFF file, or an EXIF
// block without its mark. Nothing of what is damaged or leads out of the stream.
ExifColors exifColorsOf(std::istream& tiff);

// The content of the APP1 segment of a JPEG file; empty without one.
std::string exifBlockOfJpeg(const std::filesystem::path& path);

}  // namespace cutis
