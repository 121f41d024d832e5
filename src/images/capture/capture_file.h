#pragma once

// Captures: a folder of photographs of one subject under the lights of a rig, described by
// capture.json.
//
//   { "cutis_capture": 1, "rig": "monitor", "encoding": "linear",
//     "images": [ {"light": "white", "file": "white.exr", "scale": [1, 1, 1]}, … ],
//     "mask": "mask.png" }
//
// "simulated": true says that the skin is a model's own, which leaves nothing over.
//
// Pixels are linear, also those of integer images, or have the curve of the colour space that
// `encoding` names in version 2, which is undone; what photographs say of themselves must agree,
// unless `encoding` is "raw". A perfect diffuser under the light reads 1 in every channel once
// multiplied by `scale`. Files lie in or below the folder. Lights of the rig
// that are not there are left out of it. Colours that are stored multiplied by alpha are divided by
// it, and pixels of alpha 0 are masked. Pixels at the end of an integer range are saturated; see
// classify() for the other states.
//
// Errors are sentences that name the file and the field.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"
#include "core/rig/measurements.h"
#include "src/images/codec/metadata.h"
#include "src/images/codec/sample_type.h"
#include "src/images/pixels/orientation.h"
#include "src/images/source_reference.h"

namespace cutis {

struct CaptureReadOptions {
  // Name or path, instead of the capture's own; empty: its own.
  std::string rig = {};
  // Only these, which must be there; empty: all that are there.
  std::vector<std::string> lights = {};
  // Instead of the capture's own; empty: its own, if any.
  std::filesystem::path mask = {};
};

struct Capture {
  std::string encoding;                  // as capture.json names it
  std::vector<std::string> lights;       // all that there are, also those that were not asked for
  Measurements measurements;             // channels in the order of the rig
  std::vector<SourceReference> sources;  // one per light, in the order of the rig
  ImageMetadata metadata;                // of the first light's photograph
  // How that lies in its file; the measurements stand upright.
  Orientation orientation = Orientation::upright;
};

// `path` is the folder or its capture.json. Planes hold what the files hold, without loss.
Result<Capture> readCapture(const std::filesystem::path& path, const CaptureReadOptions& options,
                            const std::shared_ptr<TileStore>& store, const JobContext& context);

// Whether the path is a capture, a folder or a JSON file, and not a single image.
bool looksLikeCapture(const std::filesystem::path& path);

struct CaptureWriteOptions {
  // What capture.json calls the rig: a built-in name, or the path of a file, which is written
  // relative to the capture. Empty: the rig's own name.
  std::string rig = {};
  SampleType sampleType = SampleType::half;  // half, float32: .exr; uint16: .tif; uint8: .png
  Plane mask = {};                           // written as mask.png unless empty
  ImageMetadata metadata = {};
  // Puts further files beside the photographs before the capture appears.
  std::function<Status(const std::filesystem::path& folder)> extra = {};
};

// The files that writeCapture() would write, less what `extra` adds, in the order of the lights,
// then mask.png and capture.json.
std::vector<std::string> captureFileNames(const Rig& rig, SampleType type);

// Writes a new folder as a whole or not at all. In a folder that is a capture already, each file is
// replaced as a whole, capture.json last; any other folder with something in it is refused.
Status writeCapture(const std::filesystem::path& folder, const Measurements& measurements,
                    const CaptureWriteOptions& options, const JobContext& context);

}  // namespace cutis
