#include "src/images/inputs/png_check.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>
#include <zlib.h>

namespace cutis {
namespace {

constexpr std::streamsize kSignatureBytes = 8;
constexpr std::size_t kBufferBytes = std::size_t{1} << 20;

std::uint32_t bigEndian(const unsigned char* bytes) {
  return (std::uint32_t{bytes[0]} << 24) | (std::uint32_t{bytes[1]} << 16) |
         (std::uint32_t{bytes[2]} << 8) | std::uint32_t{bytes[3]};
}

bool readBytes(std::ifstream& stream, unsigned char* out, std::size_t count) {
  stream.read(reinterpret_cast<char*>(out), static_cast<std::streamsize>(count));
  return static_cast<std::size_t>(stream.gcount()) == count;
}

}  // namespace

Status checkPngChunks(const std::filesystem::path& path, PngExtent extent,
                      const JobContext& context) {
  const auto cutOff = [&] {
    return inputError(path.string(), "the PNG file is cut off; get a complete copy");
  };
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(kSignatureBytes);
  std::vector<unsigned char> buffer(kBufferBytes);
  for (;;) {
    unsigned char head[8] = {};
    if (!readBytes(stream, head, sizeof head)) return cutOff();
    const std::string name(reinterpret_cast<const char*>(head + 4), 4);
    if (extent == PngExtent::beforePixels && name == "IDAT") return {};
    // CRC-32 of ISO 3309, as PNG annex D gives it.
    uLong crc = crc32(0, head + 4, 4);
    for (std::size_t left = bigEndian(head); left > 0;) {
      if (context.stopRequested()) return Cancelled{};
      const std::size_t count = std::min(left, buffer.size());
      if (!readBytes(stream, buffer.data(), count)) return cutOff();
      crc = crc32(crc, buffer.data(), static_cast<uInt>(count));
      left -= count;
    }
    unsigned char stored[4] = {};
    if (!readBytes(stream, stored, sizeof stored)) return cutOff();
    if (bigEndian(stored) != crc) {
      return inputError(path.string(),
                        "the PNG file is damaged (a checksum does not match); get a sound copy");
    }
    if (name == "IEND") return {};
  }
}

}  // namespace cutis
