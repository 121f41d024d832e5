#pragma once

// The formats of picture files, one row each: what dialogs offer, what the command line accepts and
// what the reader and the writer do with a format come from this table.
//
// A new format to write is a row here; a new kind of file a row and a value of ImageFileKind.
// Thread-safe: constants.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "src/images/codec/sample_type.h"

namespace cutis {

enum class ImageFileKind { openExr, tiff, png, jpeg, bmp, targa, radiance, psd, webP, heic };

// Bytes at a place of a file.
struct FileMark {
  std::string_view bytes;
  std::size_t at = 0;
};

struct ImageFormat {
  ImageFileKind kind = ImageFileKind::openExr;
  std::string_view name;         // "OpenEXR", as people read it
  std::string_view libraryName;  // of OpenImageIO's reader and writer
  // In lower case with the dot, the usual one first.
  std::vector<std::string_view> extensions;
  std::string_view opening = {};  // what all files begin with, beside a mark
  // By one of which a file is recognised; none: by its name.
  std::vector<FileMark> marks;
  // What can be written, the most usual first; none: files are only read.
  std::vector<SampleType> sampleTypes;
  bool colorsOnly = false;  // one or three channels and alpha, nothing else
  bool holdsAlpha = true;
  bool holdsMaps = false;             // several named parts of floats
  std::string_view compression = {};  // that is written; empty: the library's
  int quality = 0;                    // of a lossy compression, to 100; 0: there is none

  bool isWritten() const { return !sampleTypes.empty(); }
};

// In the order in which they are offered.
std::span<const ImageFormat> imageFormats();
const ImageFormat& imageFormat(ImageFileKind kind);

// The format that a picture of this name is written in. A usage error for any other.
Result<const ImageFormat*> writtenFormat(const std::filesystem::path& path);

// ".exr, .tif, .png or .jpg": the usual extensions of the formats that are written.
std::string writtenExtensions();
// "OpenEXR, TIFF, … or Radiance HDR": what is read.
std::string readFormatNames();

}  // namespace cutis
