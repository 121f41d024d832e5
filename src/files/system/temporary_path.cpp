#include "src/files/system/temporary_path.h"

#include <atomic>
#include <charconv>
#include <mutex>
#include <set>
#include <string>
#include <system_error>

#include "src/files/system/platform.h"

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

// The parts of a temporary's name that stand before the process and after the number.
struct NameParts {
  std::string front;
  std::string back;
};

NameParts namePartsOf(const fs::path& path) {
  // A name may have 255 bytes, and what the file's own is given here must fit in as well. No writer
  // knows an extension as long as that.
  return {"." + shortened(path.stem().string(), 100) + "-",
          ".partial" + shortened(path.extension().string(), 100)};
}

// Whether a process that is no more has named it: ".anything-PROCESS-NUMBER.partial.ext".
bool isAbandoned(const fs::path& path) {
  const std::string name = path.filename().string();
  const auto end = name.rfind(".partial");
  if (!name.starts_with('.') || end == std::string::npos) return false;
  const auto number = name.rfind('-', end);
  const auto begin =
      number == std::string::npos || number == 0 ? std::string::npos : name.rfind('-', number - 1);
  if (begin == std::string::npos) return false;
  unsigned long process = 0;
  const char* last = name.data() + number;
  const auto [after, failure] = std::from_chars(name.data() + begin + 1, last, process);
  if (failure != std::errc() || after != last) return false;
  // A number comes again; our own temporaries are known.
  if (process != processId()) return !isProcessAlive(process);
  const std::scoped_lock lock(registry().mutex);
  return registry().paths.count(path) == 0;
}

void removeAll(const fs::path& path) {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

}  // namespace

fs::path temporaryBeside(const fs::path& path) {
  static std::atomic<unsigned> serial = 0;
  const NameParts parts = namePartsOf(path);
  return path.parent_path() /
         (parts.front + std::to_string(processId()) + "-" + std::to_string(serial++) + parts.back);
}

std::vector<fs::path> abandonedIn(const fs::path& folder) {
  std::vector<fs::path> abandoned;
  std::error_code error;
  for (auto at = fs::directory_iterator(folder, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    if (isAbandoned(at->path())) abandoned.push_back(at->path());
  }
  return abandoned;
}

std::vector<fs::path> abandonedBeside(const fs::path& path) {
  const NameParts parts = namePartsOf(path);
  std::vector<fs::path> abandoned =
      abandonedIn(path.has_parent_path() ? path.parent_path() : fs::path("."));
  std::erase_if(abandoned, [&](const fs::path& file) {
    const std::string name = file.filename().string();
    return !name.starts_with(parts.front) || !name.ends_with(parts.back);
  });
  return abandoned;
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
