#include "src/files/io/atomic_write.h"

#include <atomic>
#include <fstream>
#include <string>
#include <system_error>

#include "src/files/io/platform.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// The first `bytes` of a name or fewer, cut between two characters of UTF-8.
std::string shortened(std::string name, std::size_t bytes) {
  if (name.size() <= bytes) return name;
  while (bytes > 0 && (static_cast<unsigned char>(name[bytes]) & 0xC0) == 0x80)
    --bytes;
  name.resize(bytes);
  return name;
}

// A name may have 255 bytes, and what the file's own is given here must fit in as well. No writer
// knows an extension as long as that.
fs::path temporaryBeside(const fs::path& path) {
  static std::atomic<unsigned> serial = 0;
  const std::string name = "." + shortened(path.stem().string(), 100) + "-" +
                           std::to_string(processId()) + "-" + std::to_string(serial++) +
                           ".partial" + shortened(path.extension().string(), 100);
  return folderOf(path) / name;
}

// Removes the file unless it was renamed away.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

Status checkWritable(const fs::path& path) {
  std::error_code error;
  const fs::path folder = folderOf(path);
  if (!fs::is_directory(folder, error)) {
    return resourceError(path.string(), "the folder '" + folder.string() +
                                            "' does not exist; create it or write elsewhere");
  }
  const bool isFolder = fs::is_directory(path, error);
  if (error == std::errc::filename_too_long) {
    return resourceError(path.string(), "the name is too long for the disk; choose a shorter one");
  }
  if (isFolder) {
    return resourceError(path.string(), "this is a folder; name a file to write");
  }
  // A device or a pipe would be replaced by a file of its name.
  if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {
    return resourceError(path.string(), "this is not a regular file; name another to write");
  }
  if (!folderIsWritable(folder)) {
    return resourceError(path.string(), "the folder '" + folder.string() +
                                            "' cannot be written to; write elsewhere");
  }
  return {};
}

Status writeAtomically(const fs::path& path,
                       const std::function<Status(const fs::path& temporary)>& write) {
  CUTIS_CHECK(checkWritable(path));
  const TemporaryFile temporary(temporaryBeside(path));
  CUTIS_CHECK(write(temporary.path()));
  if (!flushToDisk(temporary.path())) {
    return resourceError(path.string(), "the file cannot be written to the disk; free some space");
  }
  std::error_code error;
  fs::rename(temporary.path(), path, error);
  if (error) {
    return resourceError(path.string(),
                         "the file cannot be put in place (" + error.message() + ")");
  }
  return {};
}

Status writeTextAtomically(const fs::path& path, std::string_view text) {
  return writeAtomically(path, [&](const fs::path& temporary) -> Status {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) {
      return resourceError(path.string(), "the file cannot be written; free some disk space");
    }
    return {};
  });
}

}  // namespace cutis
