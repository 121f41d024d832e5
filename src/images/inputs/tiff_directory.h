#pragma once

// The first directory of a TIFF file, field by field, for what libraries do not hand on (TIFF 6.0,
// §2; BigTIFF as well).
//
// Nothing of it is trusted: what is damaged or leads out of the file is not there. Not thread-safe.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

namespace cutis {

class TiffDirectory {
 public:
  // Whole numbers: where they lie, how many, and in how many bytes each.
  struct Field {
    std::uint64_t position = 0;
    std::uint64_t count = 0;
    int bytesEach = 0;
  };

  // Precondition: the file begins like a TIFF.
  explicit TiffDirectory(const std::filesystem::path& path);

  std::uint64_t fileLength() const { return length_; }

  // Nothing for a tag that is not there, or is no list of SHORT, LONG, LONG8 or RATIONAL; of these
  // a number and what it is divided by are two.
  std::optional<Field> find(int tag);
  // Nothing if the field reaches beyond the end of the file.
  std::optional<std::vector<std::uint64_t>> values(const Field& field);
  // Both: nothing if there is no such field.
  std::optional<std::vector<std::uint64_t>> values(int tag);

 private:
  std::optional<std::uint64_t> number(std::uint64_t position, int bytes);
  std::optional<Field> fieldAt(std::uint64_t entry);

  std::ifstream stream_;
  std::uint64_t length_ = 0;
  bool littleEndian_ = true;
  bool isBig_ = false;
};

}  // namespace cutis
