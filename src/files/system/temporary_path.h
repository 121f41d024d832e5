#pragma once

// Files and folders on their way to becoming a result, which vanish with every end of the program
// but the kill that nothing outlives.
//
// Thread-safe.

#include <filesystem>
#include <vector>

namespace cutis {

// A name that nothing has, beside `path`, with its extension: ".name-PROCESS-NUMBER.partial.ext".
// At most 255 bytes.
std::filesystem::path temporaryBeside(const std::filesystem::path& path);

// What temporaryBeside(path) named in processes that were killed, and that lies there still.
std::vector<std::filesystem::path> abandonedBeside(const std::filesystem::path& path);
// All such in a folder.
std::vector<std::filesystem::path> abandonedIn(const std::filesystem::path& folder);

// What is at the path, a file or a folder with all that is in it, is removed with this object,
// unless it was renamed away, and by removeTemporaries().
class TemporaryPath {
 public:
  explicit TemporaryPath(std::filesystem::path path);
  ~TemporaryPath();
  TemporaryPath(const TemporaryPath&) = delete;
  TemporaryPath& operator=(const TemporaryPath&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Removes all of them, for a process that ends at once: from now on no other thread begins or ends
// one.
void removeTemporaries();

}  // namespace cutis
