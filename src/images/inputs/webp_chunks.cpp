#include "src/images/inputs/webp_chunks.h"

#include <cstdint>
#include <fstream>
#include <utility>

namespace cutis {
namespace {

constexpr std::streamoff kFirstRiffChunk = 12;
constexpr std::uint32_t kLargestRiffChunk = std::uint32_t{1} << 24;  // of those that are read

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

WebPChunks readWebPChunks(const std::filesystem::path& path) {
  WebPChunks chunks;
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(kFirstRiffChunk);
  std::string head(8, '\0');
  while (stream.read(head.data(), 8)) {
    const std::string name = head.substr(0, 4);
    const std::uint32_t length = littleEndianAt(head, 4);
    const std::streamoff padding = length % 2;
    if (name == "ANMF") ++chunks.frames;
    if ((name != "ICCP" && name != "EXIF") || length > kLargestRiffChunk) {
      stream.seekg(std::streamoff{length} + padding, std::ios::cur);
      continue;
    }
    std::string content(length, '\0');
    if (!stream.read(content.data(), static_cast<std::streamsize>(length))) break;
    stream.seekg(padding, std::ios::cur);
    if (name == "ICCP")
      chunks.profile = std::move(content);
    else
      chunks.exif = withoutExifMark(content);
  }
  return chunks;
}

}  // namespace cutis
