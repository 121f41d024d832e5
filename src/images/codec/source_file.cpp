#include "src/images/codec/source_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/content_hash.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kHeadBytes = 16;
constexpr std::size_t kChunkBytes = std::size_t{1} << 22;

constexpr char kReadKinds[] = "PNG, TIFF, OpenEXR, JPEG, BMP, Targa or Radiance HDR";

// Most of them are TIFF files on the outside and would be read as their small preview.
constexpr std::array<std::string_view, 12> kRawExtensions = {
    ".arw", ".cr2", ".cr3", ".crw", ".dng", ".nef", ".nrw", ".orf", ".pef", ".raf", ".raw", ".rw2"};

std::string lowerExtension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::optional<ImageFileKind> kindOf(std::string_view head, const std::string& extension) {
  const auto begins = [&](std::string_view mark) { return head.starts_with(mark); };
  if (begins(std::string_view("\x89PNG\r\n\x1a\n", 8))) return ImageFileKind::png;
  if (begins(std::string_view("II*\0", 4)) || begins(std::string_view("MM\0*", 4)) ||
      begins(std::string_view("II+\0", 4)) || begins(std::string_view("MM\0+", 4))) {
    return ImageFileKind::tiff;
  }
  if (begins("\x76\x2f\x31\x01")) return ImageFileKind::openExr;
  if (begins("\xff\xd8\xff")) return ImageFileKind::jpeg;
  if (begins("BM")) return ImageFileKind::bmp;
  if (begins("#?RADIANCE") || begins("#?RGBE")) return ImageFileKind::radiance;
  if (extension == ".tga") return ImageFileKind::targa;
  return std::nullopt;
}

}  // namespace

std::string imageKindName(ImageFileKind kind) {
  constexpr std::array<const char*, 7> names = {"PNG", "TIFF",         "OpenEXR", "JPEG",
                                                "BMP", "Radiance HDR", "Targa"};
  return names[static_cast<std::size_t>(kind)];
}

Result<ImageFileKind> identifyImageFile(const fs::path& path) {
  const std::string place = path.string();
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status)) return inputError(place, "there is no such file; check the name");
  if (fs::is_directory(status)) {
    return inputError(place, "this is a folder; name an image in it");
  }
  if (!fs::is_regular_file(status)) {
    return inputError(place, "this is not a regular file; name an image file");
  }
  const std::string extension = lowerExtension(path);
  if (std::find(kRawExtensions.begin(), kRawExtensions.end(), extension) != kRawExtensions.end()) {
    return inputError(place,
                      "this is an undeveloped raw photograph; develop it to a linear TIFF or "
                      "OpenEXR file first");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return inputError(place, "the file cannot be opened; check its permissions");
  char head[kHeadBytes] = {};
  stream.read(head, sizeof head);
  const auto length = static_cast<std::size_t>(stream.gcount());
  if (length == 0) return inputError(place, "the file is empty; use one with content");
  const auto kind = kindOf({head, length}, extension);
  if (!kind) {
    return inputError(
        place, std::string("this is no image of a kind that is read here; use ") + kReadKinds);
  }
  return *kind;
}

Result<std::string> hashFile(const fs::path& path, const JobContext& context) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return inputError(path.string(), "the file cannot be opened; check that it is there");
  }
  ContentHash hash;
  std::vector<char> chunk(kChunkBytes);
  while (stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) ||
         stream.gcount() > 0) {
    if (context.stopRequested()) return Cancelled{};
    hash.add(std::as_bytes(std::span(chunk.data(), static_cast<std::size_t>(stream.gcount()))));
  }
  if (stream.bad()) {
    return inputError(path.string(), "the file cannot be read to its end; check the disk");
  }
  return hash.digest();
}

}  // namespace cutis
