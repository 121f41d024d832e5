#include "src/cli/output_check.h"

#include <filesystem>

#include "src/files/io/atomic_write.h"
#include "src/files/io/json_file.h"
#include "src/images/capture/capture_file.h"
#include "src/images/image_file.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

bool isSameFile(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  const fs::path first = fs::weakly_canonical(a, error);
  if (error) return false;
  const fs::path second = fs::weakly_canonical(b, error);
  return !error && first == second;
}

Result<SampleType> sampleTypeOf(const std::string& bitDepth) {
  if (bitDepth == "half") return SampleType::half;
  if (bitDepth == "float") return SampleType::float32;
  if (bitDepth == "8") return SampleType::uint8;
  if (bitDepth == "16") return SampleType::uint16;
  return usageError("--bit-depth", "'" + bitDepth + "' is unknown; choose half, float, 8 or 16");
}

}  // namespace

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

Status checkDistinct(const std::string& output, const std::string& other) {
  if (output.empty() || other.empty() || !isSameFile(output, other)) return {};
  return usageError(output, "two results cannot be one file; name another");
}

Status checkMapsOutput(const std::string& output, const std::vector<std::string>& inputs) {
  if (fs::path(output).extension() != ".exr") {
    return usageError(output, "maps are written as OpenEXR; name the file with .exr");
  }
  return checkTextOutput(output, inputs);
}

Status checkTextOutput(const std::string& output, const std::vector<std::string>& inputs) {
  CUTIS_CHECK(checkNotInput(output, inputs));
  return checkWritable(output);
}

Status checkCaptureFolder(const std::string& output) {
  const fs::path folder = fs::absolute(output).lexically_normal();
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  std::error_code error;
  if (!fs::exists(named, error)) return checkWritable(named);
  if (!fs::is_directory(named, error)) {
    return resourceError(output, "there is a file of this name; name a folder");
  }
  if (!fs::is_empty(named, error) && !fs::exists(named / "capture.json", error)) {
    return resourceError(
        output, "the folder contains something other than a capture; name a new or empty one");
  }
  return checkWritable(named / "capture.json");
}

Result<SampleType> imageOutputType(const std::string& output, const std::string& bitDepth,
                                   const std::vector<std::string>& inputs) {
  CUTIS_TRY(types, writableSampleTypes(output));
  SampleType type = types.front();
  if (!bitDepth.empty()) {
    CUTIS_TRY(asked, sampleTypeOf(bitDepth));
    type = asked;
  }
  CUTIS_CHECK(checkNotInput(output, inputs));
  CUTIS_CHECK(checkImageOutput(output, type));
  return type;
}

}  // namespace cutis
