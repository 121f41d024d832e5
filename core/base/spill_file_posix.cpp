#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <unistd.h>

#include "core/base/spill_file.h"

namespace cutis {
namespace {

class PosixSpillFile final : public SpillFile {
 public:
  PosixSpillFile(int descriptor, std::string folder)
      : descriptor_(descriptor), folder_(std::move(folder)) {}
  ~PosixSpillFile() override { ::close(descriptor_); }
  PosixSpillFile(const PosixSpillFile&) = delete;
  PosixSpillFile& operator=(const PosixSpillFile&) = delete;

  Status write(std::uint64_t offset, std::span<const std::byte> bytes) override {
    while (!bytes.empty()) {
      const ssize_t count =
          ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return failure("cannot write temporary picture data", errno);
      bytes = bytes.subspan(static_cast<std::size_t>(count));
      offset += static_cast<std::uint64_t>(count);
    }
    return {};
  }

  Status read(std::uint64_t offset, std::span<std::byte> bytes) override {
    while (!bytes.empty()) {
      const ssize_t count =
          ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return failure("cannot read temporary picture data back", errno);
      bytes = bytes.subspan(static_cast<std::size_t>(count));
      offset += static_cast<std::uint64_t>(count);
    }
    return {};
  }

 private:
  Error failure(const std::string& what, int code) const {
    return resourceError(folder_, what + " (" + std::strerror(code) +
                                      "); free some disk space there or point TMPDIR elsewhere");
  }

  int descriptor_;
  std::string folder_;
};

}  // namespace

Result<std::unique_ptr<SpillFile>> SpillFile::create() {
  std::error_code error;
  const std::string folder = std::filesystem::temp_directory_path(error).string();
  if (error) {
    const char* named = std::getenv("TMPDIR");
    return resourceError(named != nullptr ? named : "/tmp",
                         "there is no such folder for temporary files; create it or point TMPDIR "
                         "elsewhere");
  }
  std::string path = folder + "/cutis-XXXXXX";
  const int descriptor = ::mkostemp(path.data(), O_CLOEXEC);
  if (descriptor < 0) {
    return resourceError(folder, "cannot create a temporary file there (" +
                                     std::string(std::strerror(errno)) +
                                     "); make it writable or point TMPDIR elsewhere");
  }
  ::unlink(path.c_str());
  return std::unique_ptr<SpillFile>(std::make_unique<PosixSpillFile>(descriptor, folder));
}

}  // namespace cutis
