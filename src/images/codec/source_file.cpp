#include "src/images/codec/source_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/content_hash.h"
#include "src/files/io/file_extension.h"
#include "src/files/io/presence.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kHeadBytes = 18;
constexpr std::size_t kHashedBytes = std::size_t{1} << 22;

// Most of them are TIFF files on the outside and would be read as their small preview.
constexpr std::array<std::string_view, 12> kRawExtensions = {
    ".arw", ".cr2", ".cr3", ".crw", ".dng", ".nef", ".nrw", ".orf", ".pef", ".raf", ".raw", ".rw2"};

std::optional<ImageFileKind> kindOf(std::string_view head, const std::string& extension) {
  const auto matches = [&](const ImageFormat& format) {
    const auto& names = format.extensions;
    if (format.marks.empty())
      return std::find(names.begin(), names.end(), extension) != names.end();
    if (!head.starts_with(format.opening)) return false;
    return std::any_of(format.marks.begin(), format.marks.end(), [&](const FileMark& mark) {
      return head.substr(std::min(mark.at, head.size())).starts_with(mark.bytes);
    });
  };
  const auto formats = imageFormats();
  const auto found = std::find_if(formats.begin(), formats.end(), matches);
  if (found == formats.end()) return std::nullopt;
  return found->kind;
}

}  // namespace

Result<ImageFileKind> identifyImageFile(const fs::path& path) {
  const std::string place = path.string();
  CUTIS_TRY(status, presentStatus(path));
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
    return inputError(place, "this is not an image of a supported kind; use " + readFormatNames());
  }
  return *kind;
}

Result<std::string> hashFile(const fs::path& path, const JobContext& context) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return inputError(path.string(), "the file cannot be opened; check that it is there");
  }
  ContentHash hash;
  std::vector<char> chunk(kHashedBytes);
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
