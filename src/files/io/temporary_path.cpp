#include "src/files/io/temporary_path.h"

#include <atomic>
#include <mutex>
#include <set>
#include <string>
#include <system_error>

#include "src/files/io/platform.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

struct Registry {
  std::mutex mutex;
  std::multiset<fs::path> paths;
};

Registry& registry() {
  // Never destroyed: the process may be ended from another thread while it ends by itself.
  static auto& all = *new Registry;
  return all;
}

// The first `bytes` of a name or fewer, cut between two characters of UTF-8.
std::string shortened(std::string name, std::size_t bytes) {
  if (name.size() <= bytes) return name;
  while (bytes > 0 && (static_cast<unsigned char>(name[bytes]) & 0xC0) == 0x80)
    --bytes;
  name.resize(bytes);
  return name;
}

void removeAll(const fs::path& path) {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

}  // namespace

fs::path temporaryBeside(const fs::path& path) {
  static std::atomic<unsigned> serial = 0;
  // A name may have 255 bytes, and what the file's own is given here must fit in as well. No writer
  // knows an extension as long as that.
  const std::string name = "." + shortened(path.stem().string(), 100) + "-" +
                           std::to_string(processId()) + "-" + std::to_string(serial++) +
                           ".partial" + shortened(path.extension().string(), 100);
  return path.parent_path() / name;
}

TemporaryPath::TemporaryPath(fs::path path) : path_(std::move(path)) {
  const std::scoped_lock lock(registry().mutex);
  registry().paths.insert(path_);
}

TemporaryPath::~TemporaryPath() {
  removeAll(path_);
  const std::scoped_lock lock(registry().mutex);
  registry().paths.extract(path_);
}

void removeTemporaries() {
  registry().mutex.lock();
  for (const fs::path& path : registry().paths)
    removeAll(path);
}

}  // namespace cutis
