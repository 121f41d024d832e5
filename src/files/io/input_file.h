#pragma once  // internal to src/files/io

// A file, pipe or terminal that is read from its beginning to its end, without ever waiting for
// others beyond an interrupt.

#include <cstddef>
#include <filesystem>
#include <span>
#include <utility>

#include "core/base/result.h"

namespace cutis {

class InputFile {
 public:
  // Does not wait for somebody to write into a pipe.
  static Result<InputFile> open(const std::filesystem::path& path);

  InputFile(InputFile&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)), place_(std::move(other.place_)) {}
  InputFile& operator=(InputFile&&) = delete;
  ~InputFile();

  // How many bytes came, 0 at the end. Waits for at least one of a pipe or terminal; cancelled if
  // the program is interrupted meanwhile (src/files/system/interruption.h).
  Result<std::size_t> read(std::span<char> bytes);

 private:
  InputFile(int descriptor, std::string place)
      : descriptor_(descriptor), place_(std::move(place)) {}

  int descriptor_;
  std::string place_;
};

}  // namespace cutis
