#include "src/files/io/named_files.h"

#include <set>
#include <utility>

#include "src/files/io/file_extension.h"
#include "src/files/io/json_file.h"

namespace cutis {

namespace fs = std::filesystem;

bool isSameFile(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  const fs::path first = fs::weakly_canonical(a, error);
  if (error) return false;
  const fs::path second = fs::weakly_canonical(b, error);
  return !error && first == second;
}

namespace {

constexpr std::size_t kLongestPath = 4096;
constexpr char kManifest[] = "capture.json";

bool isJson(const fs::path& path) {
  const std::string extension = lowerExtension(path);
  return extension == ".json" || extension == ".cutis";
}

// Adds a file that is there and what it names, unless it is known already.
class InputCollector {
 public:
  void add(const fs::path& path) {
    std::error_code error;
    const fs::path file = fs::is_directory(path, error) ? path / kManifest : path;
    files_.push_back(path.string());
    if (file != path) files_.push_back(file.string());
    if (!isJson(file) || !fs::is_regular_file(file, error)) return;
    const fs::path canonical = fs::canonical(file, error);
    if (error || !seen_.insert(canonical.string()).second) return;
    // What cannot be read is for the reader of the file to object to.
    const auto root = readJson(file);
    if (!root) return;
    for (const std::string& text : root.value().texts())
      addNamed(text, file.parent_path());
  }

  std::vector<std::string> take() { return std::move(files_); }

 private:
  // From the folder of the file that names it; some kinds of files name from the working directory.
  void addNamed(const std::string& text, const fs::path& folder) {
    if (text.empty() || text.size() > kLongestPath) return;
    std::error_code error;
    if (fs::is_regular_file(folder / text, error)) add(folder / text);
    if (isJson(text) && fs::is_regular_file(text, error)) add(text);
  }

  std::vector<std::string> files_;
  std::set<std::string> seen_;
};

}  // namespace

std::vector<std::string> inputFiles(const std::string& path) {
  InputCollector collector;
  collector.add(path);
  return collector.take();
}

}  // namespace cutis
