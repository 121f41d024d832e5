#pragma once  // internal to src/images/capture

// capture.json by itself: what it says, checked, before any image is opened. For the files of this
// folder.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/rig/rig.h"
#include "src/images/capture/capture_file.h"

namespace cutis {

inline constexpr char kCaptureFile[] = "capture.json";
inline constexpr int kNewestCaptureVersion = 1;

struct CapturePhotograph {
  int light = 0;               // index into the rig's lights
  std::string file;            // as capture.json names it
  std::filesystem::path path;  // inside the capture's folder
  std::array<float, 3> scale = {1.0f, 1.0f, 1.0f};
};

struct CaptureManifest {
  Rig rig;                                     // with only the lights that are there
  std::vector<CapturePhotograph> photographs;  // one per light, in the order of the rig
  std::filesystem::path mask;                  // may be empty
  bool isSimulated = false;
};

Result<CaptureManifest> readCaptureManifest(const std::filesystem::path& path,
                                            const CaptureReadOptions& options);

}  // namespace cutis
