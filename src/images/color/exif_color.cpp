#include "src/images/color/exif_color.h"

#include <cstdint>
#include <fstream>
#include <istream>

#include "src/images/inputs/exif_directories.h"

namespace cutis {
namespace {

constexpr int kExifDirectory = 0x8769;
constexpr int kColorSpace = 0xa001;
constexpr int kInteropDirectory = 0xa005;
constexpr int kInteropIndex = 1;

}  // namespace

ExifColors exifColorsOf(std::istream& tiff) {
  ExifColors colors;
  ExifDirectories directories(tiff);
  const auto directoryIn = [&](std::optional<std::uint64_t> outer,
                               int tag) -> std::optional<std::uint64_t> {
    const auto at = outer ? directories.find(*outer, tag) : std::nullopt;
    return at ? directories.number(*at, 4) : std::nullopt;
  };
  const auto exif = directoryIn(directories.first(), kExifDirectory);
  if (!exif) return colors;
  if (const auto at = directories.find(*exif, kColorSpace)) {
    if (const auto value = directories.number(*at, 2)) colors.colorSpace = static_cast<int>(*value);
  }
  if (const auto interop = directoryIn(exif, kInteropDirectory)) {
    if (const auto at = directories.find(*interop, kInteropIndex))
      colors.interopIndex = directories.bytesAt(*at, 3);
  }
  return colors;
}

std::string exifBlockOfJpeg(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(2);
  unsigned char head[4] = {};
  // Segments up to the first scan; each begins with 0xff, its kind and its length.
  while (stream.read(reinterpret_cast<char*>(head), 4) && head[0] == 0xff && head[1] != 0xda) {
    const int length = (head[2] << 8 | head[3]) - 2;
    if (length < 0) break;
    if (head[1] != 0xe1) {
      stream.seekg(length, std::ios::cur);
      continue;
    }
    std::string content(static_cast<std::size_t>(length), '\0');
    if (!stream.read(content.data(), length)) break;
    if (content.starts_with(std::string_view("Exif\0\0", 6))) return content.substr(6);
  }
  return {};
}

}  // namespace cutis
