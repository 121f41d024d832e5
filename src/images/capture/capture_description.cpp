#include "src/images/capture/capture_description.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "src/files/io/atomic_write.h"
#include "src/files/rig_file.h"
#include "src/images/capture/capture_manifest.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

std::string fromFolder(const fs::path& file, const fs::path& folder) {
  if (file.is_relative()) return file.generic_string();
  return file.lexically_normal().lexically_proximate(folder).generic_string();
}

}  // namespace

std::string rigReference(const std::string& nameOrPath, const fs::path& folder) {
  const std::vector<std::string> builtIn = rigNames();
  if (std::find(builtIn.begin(), builtIn.end(), nameOrPath) != builtIn.end()) return nameOrPath;
  return fromFolder(fs::absolute(nameOrPath), folder);
}

std::string captureText(const CaptureDescription& description, const fs::path& folder) {
  nlohmann::ordered_json root;
  root["cutis_capture"] =
      description.encoding == "linear" ? kFirstCaptureVersion : kNewestCaptureVersion;
  root["rig"] = description.rig;
  root["encoding"] = description.encoding;
  root["images"] = nlohmann::ordered_json::array();
  for (const DescribedPhotograph& photograph : description.photographs) {
    root["images"].push_back(
        {{"light", photograph.light}, {"file", fromFolder(photograph.file, folder)}});
  }
  if (!description.mask.empty()) root["mask"] = fromFolder(description.mask, folder);
  if (description.isSimulated) root["simulated"] = true;
  return root.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Status writeCaptureDescription(const fs::path& folder, const CaptureDescription& description) {
  return writeTextAtomically(folder / kCaptureFile, captureText(description, folder));
}

fs::path commonFolder(const std::vector<fs::path>& files) {
  fs::path common = files.front().parent_path();
  for (const fs::path& file : files) {
    const fs::path folder = file.parent_path();
    const auto ends = std::mismatch(common.begin(), common.end(), folder.begin(), folder.end());
    fs::path shared;
    for (auto part = common.begin(); part != ends.first; ++part)
      shared /= *part;
    common = shared;
  }
  return common;
}

bool hasCaptureDescription(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / kCaptureFile, ignored);
}

}  // namespace cutis
