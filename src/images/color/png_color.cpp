#include "src/images/color/png_color.h"

#include <algorithm>
#include <fstream>
#include <vector>
#include <zlib.h>

#include "src/color/icc_profile.h"

namespace cutis {
namespace {

constexpr std::streamoff kFirstChunk = 8;
constexpr std::uint32_t kLargestChunk = std::uint32_t{1} << 24;
constexpr double kChunkScale = 100000.0;

std::uint32_t bigEndianAt(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(at, 4))
    value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

std::string bigEndian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

// All of a zlib stream; empty if it is damaged or larger than a profile may be.
std::string inflated(std::string_view compressed) {
  z_stream stream = {};
  if (inflateInit(&stream) != Z_OK) return {};
  std::vector<Bytef> input(compressed.begin(), compressed.end());
  std::vector<char> buffer(std::size_t{1} << 16);
  stream.next_in = input.data();
  stream.avail_in = static_cast<uInt>(input.size());
  std::string result;
  int state = Z_OK;
  while (state == Z_OK && result.size() <= kLargestProfileBytes) {
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(buffer.size());
    state = inflate(&stream, Z_NO_FLUSH);
    result.append(buffer.data(), buffer.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return state == Z_STREAM_END && result.size() <= kLargestProfileBytes ? result : std::string();
}

// Name, a zero, the method of compression, and the profile.
std::string profileOf(std::string_view content) {
  const std::size_t end = content.substr(0, 80).find('\0');
  if (end == std::string_view::npos || end + 2 > content.size() || content[end + 1] != 0) return {};
  return inflated(content.substr(end + 2));
}

// In the order of the chunk white comes first.
std::array<double, 8> chromaticitiesOf(std::string_view content) {
  std::array<double, 8> values = {};
  for (std::size_t i = 0; i < 8; ++i)
    values[(i + 6) % 8] = bigEndianAt(content, 4 * i) / kChunkScale;
  return values;
}

void take(const std::string& name, std::string_view content, PngColors& colors) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(content[i]); };
  if (name == "cICP" && content.size() == 4) {
    colors.cicp = CodePoints{byte(0), byte(1), byte(2), byte(3) != 0};
  } else if (name == "iCCP") {
    colors.profile = profileOf(content);
  } else if (name == "sRGB" && content.size() == 1) {
    colors.hasSrgb = true;
  } else if (name == "gAMA" && content.size() == 4) {
    colors.gamma = bigEndianAt(content, 0) / kChunkScale;
  } else if (name == "cHRM" && content.size() == 32) {
    colors.chromaticities = chromaticitiesOf(content);
  } else if (name == "eXIf") {
    colors.exif = std::string(content);
  }
}

std::string chunk(const std::string& name, const std::string& content) {
  const std::string body = name + content;
  const uLong crc =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return bigEndian(static_cast<std::uint32_t>(content.size())) + body +
         bigEndian(static_cast<std::uint32_t>(crc));
}

}  // namespace

PngColors readPngColors(const std::filesystem::path& path) {
  PngColors colors;
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(kFirstChunk);
  std::string head(8, '\0');
  while (stream.read(head.data(), 8)) {
    const std::uint32_t length = bigEndianAt(head, 0);
    const std::string name = head.substr(4);
    if (name == "IDAT" || name == "IEND") break;
    constexpr std::array<std::string_view, 6> known = {"cICP", "iCCP", "sRGB",
                                                       "gAMA", "cHRM", "eXIf"};
    const bool wanted = std::find(known.begin(), known.end(), name) != known.end();
    if (!wanted || length > kLargestChunk) {
      stream.seekg(std::streamoff{length} + 4, std::ios::cur);
      continue;
    }
    std::string content(length, '\0');
    if (!stream.read(content.data(), static_cast<std::streamsize>(length))) break;
    take(name, content, colors);
    stream.seekg(4, std::ios::cur);
  }
  return colors;
}

std::string cicpChunk(const CodePoints& points) {
  std::string content;
  for (const int value : {points.primaries, points.transfer, points.matrix, int{points.fullRange}})
    content += static_cast<char>(value);
  return chunk("cICP", content);
}

std::string profileChunk(std::string_view profile) {
  const std::string name("ICC profile\0\0", 13);
  std::string compressed(compressBound(static_cast<uLong>(profile.size())), '\0');
  auto size = static_cast<uLongf>(compressed.size());
  compress2(reinterpret_cast<Bytef*>(compressed.data()), &size,
            reinterpret_cast<const Bytef*>(profile.data()), static_cast<uLong>(profile.size()), 9);
  compressed.resize(size);
  return chunk("iCCP", name + compressed);
}

}  // namespace cutis
