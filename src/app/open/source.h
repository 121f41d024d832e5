#pragma once

// What people open: photographs of a subject under known lights, an albedo texture, or the embedded
// sample; made ready to be fitted and to be looked at.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/measurements.h"
#include "core/skin/model/measurement_geometry.h"
#include "core/skin/model/skin_model.h"
#include "src/images/capture/mask_file.h"
#include "src/images/image_file.h"
#include "src/images/source_reference.h"

namespace cutis {

struct SourceOptions {
  std::string rig;                  // name or path; empty: the capture's own, or `albedo`
  std::vector<std::string> lights;  // of a capture; empty: all
  std::filesystem::path mask;       // empty: the capture's own, if any
  // The following are of an albedo texture.
  std::string layer;       // of an OpenEXR file; see src/images/image_layers.h
  std::string colorSpace;  // empty: what the file says, see src/images/color/color_statement.h
  double exposure = 1.0;   // multiplies the linear values; positive
  // How the photographs of a capture see the skin: the surface's reflection is taken off them
  // (core/rig/surface_reflection.h). An albedo texture has none.
  MeasurementGeometry surface;
};

struct Source {
  std::string name;           // of the file or folder, for titles
  Measurements measurements;  // with the exposure of an albedo texture
  // All channels of an albedo texture as they stand in the file; nothing for photographs.
  std::optional<Image> image;
  ColorDecision colors;             // of the image: what its numbers mean, and who says so
  MeasurementGeometry surface;      // that was taken off the photographs
  std::vector<std::string> lights;  // all that a capture has, also those that are not used
  ImageMetadata metadata;
  // How the file holds what stands upright here: of a texture itself, of a capture the first
  // photograph.
  Orientation orientation = Orientation::upright;
  std::vector<SourceReference> references;
  // First light's three channels to linear Rec.709 of the same skin under D65. Exact for an
  // observer under D65; for a camera the least-squares matrix over skin of the model, with the
  // perfect diffuser kept white.
  Eigen::Matrix3d toRec709 = Eigen::Matrix3d::Identity();
};

// What a mask for this source has to fit, under a name for sentences.
MaskedPicture maskedPicture(const Source& source, const std::string& name);

// A capture's folder or capture.json, or an image. Errors are sentences about the file. preview:
// who sees an image while it is read; null: nobody.
Result<Source> openSource(const std::filesystem::path& path, const SourceOptions& options,
                          const SkinModel& model, const std::shared_ptr<TileStore>& store,
                          const JobContext& context, const PreviewSink* preview = nullptr);

// The embedded sample: simulated skin, photographed through the rig `monitor`. About 0.3 s.
Result<Source> openSample(const SkinModel& model, const std::shared_ptr<TileStore>& store,
                          const JobContext& context);

// The source for skin of another model, to which the colours of a camera's photographs under
// daylight are matched. No file is read; planes are shared.
Result<Source> sourceForModel(const Source& source, const SkinModel& model);

}  // namespace cutis
