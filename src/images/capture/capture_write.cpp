#include <algorithm>
#include <cctype>
#include <set>

#include "src/files/io/atomic_write.h"
#include "src/files/system/temporary_path.h"
#include "src/images/capture/capture_description.h"
#include "src/images/capture/capture_file.h"
#include "src/images/capture/capture_manifest.h"
#include "src/images/image_file.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr char kMaskFile[] = "mask.png";

// "studio/" names the same folder as "studio".
fs::path withoutTrailingSlash(const fs::path& folder) {
  const fs::path absolute = fs::absolute(folder).lexically_normal();
  return absolute.has_filename() ? absolute : absolute.parent_path();
}

const char* extensionOf(SampleType type) {
  if (type == SampleType::uint8) return ".png";
  return isInteger(type) ? ".tif" : ".exr";
}

// "white+blue" → "white_blue.exr"; names that become equal are told apart by a number.
std::vector<std::string> fileNames(const Rig& rig, SampleType type) {
  std::vector<std::string> names;
  std::set<std::string> used = {"mask", "maps"};
  for (const RigLight& light : rig.lights) {
    std::string stem = light.name;
    std::replace_if(
        stem.begin(), stem.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '-'; },
        '_');
    std::string unique = stem;
    for (int n = 2; !used.insert(unique).second; ++n)
      unique = stem + "_" + std::to_string(n);
    names.push_back(unique + extensionOf(type));
  }
  return names;
}

std::string manifestText(const Measurements& measurements, const CaptureWriteOptions& options,
                         const std::vector<std::string>& files, const fs::path& folder) {
  CaptureDescription description;
  description.rig = options.rig.empty() ? measurements.rig.name : rigReference(options.rig, folder);
  for (std::size_t k = 0; k < files.size(); ++k)
    description.photographs.push_back({measurements.rig.lights[k].name, files[k]});
  if (!options.mask.empty()) description.mask = kMaskFile;
  description.isSimulated = measurements.isSimulated;
  return captureText(description, folder);
}

ImageContent photographOf(const Measurements& measurements, std::size_t light,
                          const ImageMetadata& metadata) {
  ImageContent content;
  const auto& names = measurements.rig.camera.channelNames;
  content.channelNames = {names.begin(), names.end()};
  for (std::size_t c = 0; c < 3; ++c) {
    content.channels.push_back(measurements.channels[3 * light + c]);
  }
  content.metadata = metadata;
  return content;
}

// All files into `target`; `folder` is where they will be in the end.
Status writeFiles(const fs::path& target, const fs::path& folder, const Measurements& measurements,
                  const CaptureWriteOptions& options, const JobContext& context) {
  const std::vector<std::string> files = fileNames(measurements.rig, options.sampleType);
  const auto count = static_cast<double>(files.size());
  for (std::size_t k = 0; k < files.size(); ++k) {
    const auto done = static_cast<double>(k);
    CUTIS_CHECK(writeImage(target / files[k], photographOf(measurements, k, options.metadata),
                           options.sampleType,
                           context.child(0.9 * done / count, 0.9 * (done + 1.0) / count)));
  }
  if (!options.mask.empty()) {
    ImageContent mask;
    mask.channelNames = {"Y"};
    mask.channels = {options.mask};
    CUTIS_CHECK(writeImage(target / kMaskFile, mask, SampleType::uint8, context.child(0.9, 1.0)));
  }
  if (options.extra) CUTIS_CHECK(options.extra(target));
  return writeTextAtomically(target / kCaptureFile,
                             manifestText(measurements, options, files, folder));
}

Error cannotCreate(const fs::path& folder, const std::error_code& error) {
  return resourceError(folder.string(),
                       "the folder cannot be created (" + error.message() + "); write elsewhere");
}

// capture.json comes last: without it the folder is no capture.
Status moveFiles(const fs::path& from, const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(from, error))
    files.push_back(entry.path());
  std::partition(files.begin(), files.end(),
                 [](const fs::path& file) { return file.filename() != kCaptureFile; });
  for (const fs::path& file : files) {
    if (!error) fs::rename(file, folder / file.filename(), error);
  }
  if (!error) return {};
  return resourceError(folder.string(),
                       "the files cannot be put in place (" + error.message() + ")");
}

Status writeNewFolder(const fs::path& folder, const Measurements& measurements,
                      const CaptureWriteOptions& options, const JobContext& context) {
  const TemporaryPath temporary(temporaryBeside(folder));
  std::error_code error;
  fs::create_directory(temporary.path(), error);
  if (error) return cannotCreate(folder, error);
  CUTIS_CHECK(writeFiles(temporary.path(), folder, measurements, options, context));
  fs::rename(temporary.path(), folder, error);
  if (error) return cannotCreate(folder, error);
  return {};
}

// An empty folder keeps its permissions, and may be a link or a disk of its own.
Status fillFolder(const fs::path& folder, const Measurements& measurements,
                  const CaptureWriteOptions& options, const JobContext& context) {
  const TemporaryPath temporary(temporaryBeside(folder / "capture"));
  std::error_code error;
  fs::create_directory(temporary.path(), error);
  if (error) return cannotCreate(folder, error);
  CUTIS_CHECK(writeFiles(temporary.path(), folder, measurements, options, context));
  return moveFiles(temporary.path(), folder);
}

}  // namespace

std::vector<std::string> captureFileNames(const Rig& rig, SampleType type) {
  std::vector<std::string> names = fileNames(rig, type);
  names.emplace_back(kMaskFile);
  names.emplace_back(kCaptureFile);
  return names;
}

Status writeCapture(const fs::path& path, const Measurements& measurements,
                    const CaptureWriteOptions& options, const JobContext& context) {
  const fs::path folder = withoutTrailingSlash(path);
  const std::string place = path.string();
  std::error_code ignored;
  if (fs::is_symlink(folder, ignored) && !fs::exists(folder, ignored)) {
    return resourceError(place, "this is a link that leads to no folder; mend the link");
  }
  if (!fs::exists(folder, ignored)) {
    return writeNewFolder(folder, measurements, options, context);
  }
  if (!fs::is_directory(folder, ignored)) {
    return resourceError(place, "there is a file of this name; name a folder");
  }
  if (fs::is_empty(folder, ignored)) {
    return fillFolder(folder, measurements, options, context);
  }
  if (!fs::exists(folder / kCaptureFile, ignored)) {
    return resourceError(
        place, "the folder contains something other than a capture; name a new or empty one");
  }
  return writeFiles(folder, folder, measurements, options, context);
}

}  // namespace cutis
