#include "core/render/render_picture.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "core/base/parallel.h"

namespace cutis {
namespace {

// Calls work(rect) for each tile of the maps.
Status forEachTile(const ChromophoreMaps& maps, const JobContext& context,
                   const std::function<Status(const Rect&)>& work) {
  const Plane& state = maps.state;
  return parallelFor(static_cast<std::size_t>(state.tileCount()), context,
                     [&](std::size_t i) { return work(state.tileRect(static_cast<int>(i))); });
}

}  // namespace

Result<PictureBuffer> renderPart(const EditedSkin& skin, const ResponseModel& response,
                                 const Rect& rect, int step) {
  CUTIS_TRY(samples, loadSamples(skin, rect, step));
  return renderSamples(samples, skin.edits, skin.axes(), response);
}

Result<std::vector<Plane>> renderPicture(const EditedSkin& skin, const ResponseModel& response,
                                         const std::shared_ptr<TileStore>& store,
                                         const JobContext& context) {
  std::vector<Plane> planes;
  for (int k = 0; k < response.rowCount(); ++k) {
    planes.emplace_back(skin.width(), skin.height(), PixelFormat::float32, store);
  }
  CUTIS_CHECK(forEachTile(skin.maps, context, [&](const Rect& rect) -> Status {
    CUTIS_TRY(part, renderPart(skin, response, rect, 1));
    for (std::size_t k = 0; k < planes.size(); ++k) {
      CUTIS_CHECK(planes[k].store(rect, part.channels[k]));
    }
    return {};
  }));
  return planes;
}

Result<ChromophoreMaps> editMaps(const EditedSkin& skin, const std::shared_ptr<TileStore>& store,
                                 const JobContext& context) {
  ChromophoreMaps edited(skin.width(), skin.height(), PixelFormat::float32, store);
  edited.state = skin.maps.state;
  edited.constants = skin.maps.constants;
  edited.coefficients = skin.maps.coefficients;
  edited.surface = skin.maps.surface;
  CUTIS_CHECK(forEachTile(skin.maps, context, [&](const Rect& rect) -> Status {
    CUTIS_TRY(parameters, loadEdited(skin, rect));
    return storeParameters(parameters, rect, edited);
  }));
  return edited;
}

Result<PictureBuffer> editAlbedoPart(PictureBuffer source, const EditedSkin& skin,
                                     const ResponseModel& albedo, bool pure, const Rect& rect,
                                     int step) {
  if (!pure && isNeutral(skin.edits)) return source;
  CUTIS_TRY(samples, loadSamples(skin, rect, step));
  samples.original = responseTo(*samples.parameters, albedo);
  return editAlbedoSamples(std::move(source), samples, skin.edits, skin.axes(), albedo, pure);
}

}  // namespace cutis
