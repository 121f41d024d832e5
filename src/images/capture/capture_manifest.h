#pragma once  // internal to src/images/capture

// capture.json by itself: what it says, checked, before any image is opened. For the files of this
// folder.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/rig/rig.h"
#include "src/color/color_space.h"
#include "src/images/capture/capture_file.h"

namespace cutis {

inline constexpr char kCaptureFile[] = "capture.json";
// Read are versions up to the newest; what has no need of it is written in the first, so that older
// programs read it.
inline constexpr int kFirstCaptureVersion = 1;
inline constexpr int kNewestCaptureVersion = 2;

struct CapturePhotograph {
  int light = 0;               // index into the rig's lights
  std::string file;            // as capture.json names it
  std::filesystem::path path;  // inside the capture's folder
  std::array<float, 3> scale = {1.0f, 1.0f, 1.0f};
};

// What capture.json says that the photographs' numbers are.
struct CaptureEncoding {
  std::string name = "linear";  // as capture.json has it
  // The curves of numbers that are not linear; linear where they are taken as they are.
  std::array<TransferCurve, 3> curves;
  // "raw": whatever the photographs say of themselves does not count.
  bool isRaw = false;

  bool isLinear() const;
};

struct CaptureManifest {
  Rig rig;  // with only the lights that are there
  CaptureEncoding encoding;
  std::vector<std::string> lights;  // all that there are photographs of
  std::vector<CapturePhotograph>
      photographs;             // of those asked for, one per light, in the order of the rig
  std::filesystem::path mask;  // may be empty
  bool isSimulated = false;
};

// `notice` hears what of the rig's files was left out.
Result<CaptureManifest> readCaptureManifest(const std::filesystem::path& path,
                                            const CaptureReadOptions& options,
                                            const Notice& notice);

}  // namespace cutis
