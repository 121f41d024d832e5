#include "src/images/codec/image_formats.h"

#include <algorithm>

#include "core/base/word_list.h"
#include "src/files/io/file_extension.h"

namespace cutis {
namespace {

using namespace std::string_view_literals;
using enum SampleType;

const std::vector<ImageFormat>& table() {
  static const std::vector<ImageFormat> formats = {
      {.kind = ImageFileKind::openExr,
       .name = "OpenEXR",
       .libraryName = "openexr",
       .extensions = {".exr"},
       .marks = {{"\x76\x2f\x31\x01"sv}},
       .sampleTypes = {half, float32},
       .holdsMaps = true,
       .compression = "zip"},
      {.kind = ImageFileKind::tiff,
       .name = "TIFF",
       .libraryName = "tiff",
       .extensions = {".tif", ".tiff"},
       .marks = {{"II*\0"sv}, {"MM\0*"sv}, {"II+\0"sv}, {"MM\0+"sv}},
       .sampleTypes = {uint16, uint8, float32},
       .compression = "zip"},
      {.kind = ImageFileKind::png,
       .name = "PNG",
       .libraryName = "png",
       .extensions = {".png"},
       .marks = {{"\x89PNG\r\n\x1a\n"sv}},
       .sampleTypes = {uint8, uint16},
       .colorsOnly = true,
       .compression = "zip"},
      {.kind = ImageFileKind::jpeg,
       .name = "JPEG",
       .libraryName = "jpeg",
       .extensions = {".jpg", ".jpeg"},
       .marks = {{"\xff\xd8\xff"sv}},
       .sampleTypes = {uint8},
       .colorsOnly = true,
       .holdsAlpha = false,
       .quality = 95},
      {.kind = ImageFileKind::bmp,
       .name = "BMP",
       .libraryName = "bmp",
       .extensions = {".bmp"},
       .opening = "BM",
       // The length of the header that follows: of OS/2, of Windows 3 to 5 and of what other
       // programs write between these.
       .marks = {{"\x0c\0\0\0"sv, 14},
                 {"\x10\0\0\0"sv, 14},
                 {"\x28\0\0\0"sv, 14},
                 {"\x34\0\0\0"sv, 14},
                 {"\x38\0\0\0"sv, 14},
                 {"\x40\0\0\0"sv, 14},
                 {"\x6c\0\0\0"sv, 14},
                 {"\x7c\0\0\0"sv, 14}},
       .sampleTypes = {}},
      {.kind = ImageFileKind::targa,
       .name = "Targa",
       .libraryName = "targa",
       .extensions = {".tga"},
       .marks = {},
       .sampleTypes = {}},
      {.kind = ImageFileKind::radiance,
       .name = "Radiance HDR",
       .libraryName = "hdr",
       .extensions = {".hdr"},
       .marks = {{"#?RADIANCE"sv}, {"#?RGBE"sv}},
       .sampleTypes = {}},
      {.kind = ImageFileKind::psd,
       .name = "Photoshop",
       .libraryName = "psd",
       .extensions = {".psd"},
       .marks = {{"8BPS"sv}},
       .sampleTypes = {}},
      {.kind = ImageFileKind::webP,
       .name = "WebP",
       .libraryName = "webp",
       .extensions = {".webp"},
       .marks = {{"WEBP"sv, 8}},
       .sampleTypes = {}},
      {.kind = ImageFileKind::heic,
       .name = "HEIC",
       .libraryName = "heif",
       .extensions = {".heic", ".heif", ".avif"},
       .marks = {{"ftypheic"sv, 4},
                 {"ftypheix"sv, 4},
                 {"ftypheim"sv, 4},
                 {"ftypmif1"sv, 4},
                 {"ftypavif"sv, 4}},
       .sampleTypes = {}},
  };
  return formats;
}

}  // namespace

std::span<const ImageFormat> imageFormats() {
  return table();
}

const ImageFormat& imageFormat(ImageFileKind kind) {
  return *std::find_if(table().begin(), table().end(),
                       [kind](const ImageFormat& format) { return format.kind == kind; });
}

Result<const ImageFormat*> writtenFormat(const std::filesystem::path& path) {
  const std::string extension = lowerExtension(path);
  for (const ImageFormat& format : table()) {
    const auto& names = format.extensions;
    if (format.isWritten() && std::find(names.begin(), names.end(), extension) != names.end()) {
      return &format;
    }
  }
  return usageError(path.string(), "images are written as " + writtenExtensions() +
                                       "; name the file with one of these");
}

std::string writtenExtensions() {
  std::vector<std::string_view> usual;
  for (const ImageFormat& format : table()) {
    if (format.isWritten()) usual.push_back(format.extensions.front());
  }
  return wordList(usual, " or ");
}

std::string readFormatNames() {
  std::vector<std::string_view> names;
  for (const ImageFormat& format : table())
    names.push_back(format.name);
  return wordList(names, " or ");
}

}  // namespace cutis
