#pragma once  // internal to core/base

// A temporary file that nobody else sees and that vanishes with the process, even after a crash.
// Holds tiles that do not fit the memory budget. Thread-safe.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "core/base/result.h"

namespace cutis {

class SpillFile {
 public:
  // Created in the system's folder for temporary files ($TMPDIR on POSIX).
  static Result<std::unique_ptr<SpillFile>> create();
  virtual ~SpillFile() = default;

  virtual Status write(std::uint64_t offset, std::span<const std::byte> bytes) = 0;
  // Fails if fewer bytes are there.
  virtual Status read(std::uint64_t offset, std::span<std::byte> bytes) = 0;
};

}  // namespace cutis
