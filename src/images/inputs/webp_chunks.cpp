#include "src/images/color/webp_color.h"

#include <cstdint>
#include <fstream>

#include "src/color/icc_profile.h"

namespace cutis {
namespace {

constexpr std::streamoff kFirstRiffChunk = 12;

std::uint32_t littleEndianAt(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

// As in JPEG files the mark of EXIF may stand before it.
std::string withoutExifMark(const std::string& block) {
  const std::string mark("Exif\0\0", 6);
  return block.starts_with(mark) ? block.substr(mark.size()) : block;
}

}  // namespace

WebPColors readWebPColors(const std::filesystem::path& path) {
  WebPColors colors;
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(kFirstRiffChunk);
  std::string head(8, '\0');
  while (stream.read(head.data(), 8)) {
    const std::string name = head.substr(0, 4);
    const std::uint32_t length = littleEndianAt(head, 4);
    const std::streamoff padding = length % 2;
    if ((name != "ICCP" && name != "EXIF") || length > kLargestProfileBytes) {
      stream.seekg(std::streamoff{length} + padding, std::ios::cur);
      continue;
    }
    std::string content(length, '\0');
    if (!stream.read(content.data(), static_cast<std::streamsize>(length))) break;
    stream.seekg(padding, std::ios::cur);
    if (name == "ICCP")
      colors.profile = std::move(content);
    else
      colors.exif = withoutExifMark(content);
  }
  return colors;
}

}  // namespace cutis
