#pragma once

// What a capture.json says, to be written beside photographs that are there already.

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace cutis {

struct DescribedPhotograph {
  std::string light;
  std::filesystem::path file;  // absolute, or relative to the capture's folder
};

struct CaptureDescription {
  std::string rig;  // see rigReference()
  // "linear", "raw" or the name of a colour space.
  std::string encoding = "linear";
  std::vector<DescribedPhotograph> photographs;
  std::filesystem::path mask;  // as the photographs' files; may be empty
  bool isSimulated = false;
};

// How a capture.json in `folder` names a rig: a built-in name, or the path of a file from there.
std::string rigReference(const std::string& nameOrPath, const std::filesystem::path& folder);

// In the oldest version of the format that can say it. Files are named from `folder`.
std::string captureText(const CaptureDescription& description, const std::filesystem::path& folder);

// Replaces the capture.json of the folder as a whole; no photograph is touched. The photographs lie
// in or below the folder.
Status writeCaptureDescription(const std::filesystem::path& folder,
                               const CaptureDescription& description);

// The folder that holds all of the files, as deep as possible. Precondition: at least one.
std::filesystem::path commonFolder(const std::vector<std::filesystem::path>& files);

// Whether the folder is described already.
bool hasCaptureDescription(const std::filesystem::path& folder);

}  // namespace cutis
