#include "src/app/open/source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "core/base/choice_place.h"
#include "core/rig/surface_reflection.h"
#include "core/simulate/photograph.h"
#include "core/simulate/skin_patch.h"
#include "core/spectra/colorimetry.h"
#include "src/app/open/daylight_matrix.h"
#include "src/files/recipe_file.h"
#include "src/files/rig_file.h"
#include "src/files/spectral_library.h"
#include "src/images/capture/albedo_file.h"
#include "src/images/capture/capture_file.h"

namespace cutis {
namespace {

constexpr char kAlbedoRig[] = "albedo";
constexpr char kSampleRig[] = "monitor";
constexpr double kSampleNoise = 0.005;
// Half a step of an 8-bit sRGB texture at middle grey, as a standard deviation of linear values.
constexpr double kEightBitRead = 0.0005;

std::string titleOf(const std::filesystem::path& path) {
  const auto name =
      path.filename() == "capture.json" ? path.parent_path().filename() : path.filename();
  return name.empty() ? path.string() : name.string();
}

Result<Source> openAlbedo(const std::filesystem::path& path, const SourceOptions& options,
                          const std::shared_ptr<TileStore>& store, const JobContext& context,
                          const PreviewSink* preview) {
  if (!options.lights.empty()) {
    return usageError(kLightsChoice, "a single image has one light; name a capture");
  }
  if (options.surface.specularShare > 0.0) {
    return usageError(kSurfaceChoice,
                      "a single image is taken as albedo, without the reflection of the surface; "
                      "this is for captures");
  }
  if (!std::isfinite(options.exposure) || !(options.exposure > 0.0)) {
    return usageError(kExposureChoice, "the exposure must be a positive number");
  }
  CUTIS_TRY(
      rig, loadRig(options.rig.empty() ? kAlbedoRig : options.rig, {}, kRigChoice, context.notice));
  CUTIS_TRY(albedo, readAlbedo(path, {options.colorSpace, options.mask, options.layer, preview},
                               rig, store, context));
  Source source;
  source.name = titleOf(path);
  source.measurements = std::move(albedo.measurements);
  if (albedo.source.sourceType == SampleType::uint8) {
    source.measurements.rig.noise.read =
        std::max(source.measurements.rig.noise.read, kEightBitRead);
  }
  source.colors = std::move(albedo.colors);
  source.measurements.exposure = options.exposure;
  source.metadata = albedo.source.metadata;
  source.orientation = albedo.source.orientation;
  source.references = {{path.filename().string(), albedo.source.contentHash}};
  source.image = std::move(albedo.source);
  const Eigen::Vector3d white = whitePoint(rig.lights.front().power, rig.camera.sensor);
  source.toRec709 = xyzFromRec709(white).inverse() * white.asDiagonal();
  return source;
}

Result<Source> openCapture(const std::filesystem::path& path, const SourceOptions& options,
                           const SkinModel& model, const std::shared_ptr<TileStore>& store,
                           const JobContext& context) {
  if (!options.layer.empty()) {
    return usageError(kLayerChoice, "the layer is chosen of a single image; leave this out");
  }
  if (!options.colorSpace.empty() || options.exposure != 1.0) {
    return usageError(options.colorSpace.empty() ? kExposureChoice : kColorSpaceChoice,
                      "a capture is linear and calibrated; this is for single images");
  }
  CUTIS_TRY(capture,
            readCapture(path, {options.rig, options.lights, options.mask}, store, context));
  Source source;
  source.name = titleOf(path);
  source.lights = std::move(capture.lights);
  source.measurements = std::move(capture.measurements);
  source.surface = options.surface;
  CUTIS_CHECK(removeSurfaceReflection(options.surface, store, {context.stop, {}, context.notice},
                                      source.measurements));
  source.metadata = std::move(capture.metadata);
  source.orientation = capture.orientation;
  source.references = std::move(capture.sources);
  CUTIS_TRY(matrix, daylightMatrix(source.measurements.rig, model));
  source.toRec709 = matrix;
  return source;
}

}  // namespace

MaskedPicture maskedPicture(const Source& source, const std::string& name) {
  MaskedPicture picture = {source.measurements.width(), source.measurements.height(), name};
  picture.orientation = source.orientation;
  if (source.image) picture.display = source.image->frame.display;
  return picture;
}

Result<Source> openSource(const std::filesystem::path& path, const SourceOptions& options,
                          const SkinModel& model, const std::shared_ptr<TileStore>& store,
                          const JobContext& context, const PreviewSink* preview) {
  if (looksLikeCapture(path)) return openCapture(path, options, model, store, context);
  return openAlbedo(path, options, store, context, preview);
}

Result<Source> openSample(const SkinModel& model, const std::shared_ptr<TileStore>& store,
                          const JobContext& context) {
  CUTIS_TRY(recipe, loadRecipe(kSampleRecipe, {}));
  CUTIS_TRY(rig, loadRig(kSampleRig, {}, {}));
  CUTIS_TRY(skin, simulateSkin(recipe.skin, recipe.width, recipe.height, recipe.seed,
                               model.profile().axes, store, context.child(0.0, 0.4)));
  CUTIS_TRY(measurements,
            photograph(skin, model, rig, kSampleNoise, recipe.seed, context.child(0.4, 1.0)));
  Source source;
  source.name = "Sample face patch";
  source.measurements = std::move(measurements);
  CUTIS_TRY(matrix, daylightMatrix(rig, model));
  source.toRec709 = matrix;
  return source;
}

Result<Source> sourceForModel(const Source& source, const SkinModel& model) {
  Source matched = source;
  if (source.image) return matched;
  CUTIS_TRY(matrix, daylightMatrix(source.measurements.rig, model));
  matched.toRec709 = matrix;
  return matched;
}

}  // namespace cutis
