#include "src/images/color/exif_color.h"

#include <cstdint>
#include <fstream>
#include <istream>

namespace cutis {
namespace {

constexpr int kExifDirectory = 0x8769;
constexpr int kColorSpace = 0xa001;
constexpr int kInteropDirectory = 0xa005;
constexpr int kInteropIndex = 1;
constexpr std::uint64_t kMostEntries = 4096;

// Classic TIFF; BigTIFF is too rare a photograph.
class Directories {
 public:
  explicit Directories(std::istream& stream) : stream_(stream) {
    std::string mark(4, '\0');
    stream_.seekg(0);
    stream_.read(mark.data(), 4);
    littleEndian_ = mark.starts_with("II");
    isTiff_ = stream_ && (mark == std::string("II*\0", 4) || mark == std::string("MM\0*", 4));
  }

  std::optional<std::uint64_t> first() { return isTiff_ ? number(4, 4) : std::nullopt; }

  // Where the value of a tag lies in the entry; nothing if the directory has no such tag.
  std::optional<std::uint64_t> find(std::uint64_t directory, int tag) {
    const auto entries = number(directory, 2);
    if (!entries || *entries > kMostEntries) return std::nullopt;
    for (std::uint64_t i = 0; i < *entries; ++i) {
      const std::uint64_t entry = directory + 2 + 12 * i;
      const auto name = number(entry, 2);
      if (!name) return std::nullopt;
      if (*name == static_cast<std::uint64_t>(tag)) return entry + 8;
    }
    return std::nullopt;
  }

  std::optional<std::uint64_t> number(std::uint64_t position, int bytes) {
    const std::string text = bytesAt(position, bytes);
    if (text.empty()) return std::nullopt;
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) {
      const int at = littleEndian_ ? bytes - 1 - i : i;
      value = value << 8 | static_cast<unsigned char>(text[static_cast<std::size_t>(at)]);
    }
    return value;
  }

  std::string bytesAt(std::uint64_t position, int count) {
    std::string text(static_cast<std::size_t>(count), '\0');
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(position));
    if (!stream_.read(text.data(), count)) return {};
    return text;
  }

 private:
  std::istream& stream_;
  bool littleEndian_ = false;
  bool isTiff_ = false;
};

}  // namespace

ExifColors exifColorsOf(std::istream& tiff) {
  ExifColors colors;
  Directories directories(tiff);
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
