#pragma once

// The directories of an EXIF block, which is a TIFF structure, entry by entry, for what OpenImageIO
// does not read (Exif 2.32, §4.6; TIFF 6.0, §2).
//
// Nothing of it is trusted: what is damaged or leads out of the stream is not there. Classic TIFF;
// BigTIFF is too rare a photograph. Not thread-safe.

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

namespace cutis {

class ExifDirectories {
 public:
  // A TIFF structure that begins at the beginning of the stream, which outlives this.
  explicit ExifDirectories(std::istream& stream);

  // Where the first directory begins.
  std::optional<std::uint64_t> first();
  // Where the value of a tag lies in the entry; nothing if the directory has no such tag.
  std::optional<std::uint64_t> find(std::uint64_t directory, int tag);
  std::optional<std::uint64_t> number(std::uint64_t position, int bytes);
  // Empty if there are fewer.
  std::string bytesAt(std::uint64_t position, int count);

 private:
  std::istream& stream_;
  bool littleEndian_ = false;
  bool isTiff_ = false;
};

// The tag Orientation of a block; 1, upright, where it says nothing.
int exifOrientation(const std::string& block);

}  // namespace cutis
