#include "src/app/export/overwrite_protection.h"

#include "src/files/io/json_file.h"
#include "src/images/capture/capture_file.h"

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

Result<std::vector<std::string>> inputFiles(const std::string& path) {
  std::vector<std::string> files = {path};
  if (!looksLikeCapture(path)) return files;
  std::error_code ignored;
  const fs::path manifest =
      fs::is_directory(path, ignored) ? fs::path(path) / "capture.json" : fs::path(path);
  if (!fs::exists(manifest, ignored)) return files;  // said when the capture is opened
  const fs::path folder = manifest.parent_path();
  files.push_back(manifest.string());
  CUTIS_TRY(root, readJson(manifest));
  // Only what is well said is looked at; the rest is for the reader of captures to object to.
  if (const auto mask = root.text("mask", ""); mask && !mask.value().empty()) {
    files.push_back((folder / mask.value()).string());
  }
  const auto images = root.array("images");
  if (!images) return files;
  for (const JsonValue& image : images.value()) {
    if (!image.isObject()) continue;
    if (const auto file = image.text("file", ""); file && !file.value().empty()) {
      files.push_back((folder / file.value()).string());
    }
  }
  return files;
}

Status checkNotInput(const std::string& output, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    if (!input.empty() && isSameFile(output, input)) {
      return usageError(output,
                        "this file is read, and sources are never written to; write to "
                        "another file");
    }
  }
  return {};
}

}  // namespace cutis
