#include "src/cli/output_check.h"

#include <filesystem>

#include "src/files/io/atomic_write.h"
#include "src/files/io/named_files.h"

namespace cutis {

namespace fs = std::filesystem;

Status checkDistinct(const std::string& output, const std::string& other) {
  if (output.empty() || other.empty() || !isSameFile(output, other)) return {};
  return usageError(output, "two results cannot be one file; name another");
}

Status checkTextOutput(const std::string& output, const std::vector<std::string>& inputs) {
  CUTIS_CHECK(checkNotInput(output, inputs));
  return checkWritable(output);
}

Status checkCaptureFolder(const std::string& output, bool overwrite) {
  const fs::path folder = fs::absolute(output).lexically_normal();
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  std::error_code error;
  if (!fs::exists(named, error) && !fs::is_symlink(named, error)) return checkWritable(named);
  if (!fs::exists(named, error)) {
    return resourceError(output, "this is a link that leads to no folder; mend the link");
  }
  if (!fs::is_directory(named, error)) {
    return resourceError(output, "there is a file of this name; name a folder");
  }
  if (!fs::is_empty(named, error) && !fs::exists(named / "capture.json", error)) {
    return resourceError(
        output, "the folder contains something other than a capture; name a new or empty one");
  }
  if (!overwrite && !fs::is_empty(named, error)) {
    return usageError(output,
                      "photographs stand in this folder; give --overwrite to replace them, or name "
                      "another folder");
  }
  return checkWritable(named / "capture.json");
}

}  // namespace cutis
