#include "src/app/export/albedo_export.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "src/app/export/edited_source.h"
#include "src/images/image_file.h"

namespace cutis {
namespace {

Status checkIsNoSource(const std::filesystem::path& path,
                       const std::vector<std::filesystem::path>& sources) {
  for (const std::filesystem::path& source : sources) {
    std::error_code ignored;
    const bool inside = std::filesystem::is_directory(source, ignored) &&
                        std::filesystem::equivalent(path.parent_path(), source, ignored);
    if (inside || std::filesystem::equivalent(path, source, ignored)) {
      return usageError(path.string(),
                        "this is what was opened, which is never written to; choose "
                        "another name or folder");
    }
  }
  return {};
}

}  // namespace

Status exportAlbedo(const Scene& scene, Engine& engine, const std::filesystem::path& path,
                    const std::vector<std::filesystem::path>& sources,
                    const std::shared_ptr<TileStore>& store, const JobContext& context) {
  CUTIS_CHECK(checkIsNoSource(path, sources));
  CUTIS_TRY(types, writableSampleTypes(path));
  SampleType type = types.front();
  std::string space;
  if (scene.source->image) {
    const SampleType own = scene.source->image->sourceType;
    if (std::find(types.begin(), types.end(), own) != types.end()) type = own;
    if (isInteger(own) == isInteger(type)) space = scene.source->colorSpace;
  }
  if (space.empty()) space = isInteger(type) ? "sRGB" : "Linear Rec.709";
  CUTIS_CHECK(checkImageOutput(path, type));
  CUTIS_TRY(albedo, engine.picture(scene.model, PictureRequest(), "export"));
  CUTIS_TRY(content,
            editedTexture(*scene.source, scene.maps, scene.edits, scene.model->profile().axes,
                          *albedo, {space, false, scene.source->exposure}, store,
                          context.child(0.0, 0.6, "editing")));
  return writeImage(path, content, type, context.child(0.6, 1.0, "writing"));
}

}  // namespace cutis
