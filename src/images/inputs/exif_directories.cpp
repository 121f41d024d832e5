#include "src/images/inputs/exif_directories.h"

#include <istream>
#include <sstream>

namespace cutis {
namespace {

constexpr int kOrientation = 0x0112;
constexpr std::uint64_t kMostEntries = 4096;

}  // namespace

ExifDirectories::ExifDirectories(std::istream& stream) : stream_(stream) {
  std::string mark(4, '\0');
  stream_.seekg(0);
  stream_.read(mark.data(), 4);
  littleEndian_ = mark.starts_with("II");
  isTiff_ = stream_ && (mark == std::string("II*\0", 4) || mark == std::string("MM\0*", 4));
}

std::optional<std::uint64_t> ExifDirectories::first() {
  return isTiff_ ? number(4, 4) : std::nullopt;
}

std::optional<std::uint64_t> ExifDirectories::find(std::uint64_t directory, int tag) {
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

std::optional<std::uint64_t> ExifDirectories::number(std::uint64_t position, int bytes) {
  const std::string text = bytesAt(position, bytes);
  if (text.empty()) return std::nullopt;
  std::uint64_t value = 0;
  for (int i = 0; i < bytes; ++i) {
    const int at = littleEndian_ ? bytes - 1 - i : i;
    value = value << 8 | static_cast<unsigned char>(text[static_cast<std::size_t>(at)]);
  }
  return value;
}

std::string ExifDirectories::bytesAt(std::uint64_t position, int count) {
  std::string text(static_cast<std::size_t>(count), '\0');
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(position));
  if (!stream_.read(text.data(), count)) return {};
  return text;
}

int exifOrientation(const std::string& block) {
  std::istringstream stream(block);
  ExifDirectories directories(stream);
  const auto first = directories.first();
  const auto at = first ? directories.find(*first, kOrientation) : std::nullopt;
  const auto value = at ? directories.number(*at, 2) : std::nullopt;
  return value ? static_cast<int>(*value) : 1;
}

}  // namespace cutis
