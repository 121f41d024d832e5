#include "core/render/render_picture.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "core/base/parallel.h"

namespace cutis {
namespace {

// Below this a ratio of two models says nothing; far below the darkest skin in any channel.
constexpr float kSmallestAlbedo = 1e-4f;

PictureBuffer emptyPart(const Rect& rect, int step) {
  PictureBuffer part;
  part.width = (rect.width() + step - 1) / step;
  part.height = (rect.height() + step - 1) / step;
  return part;
}

// One vector per row of the response; 0 where there is no estimate.
std::vector<std::vector<float>> evaluate(const ParameterBuffer& parameters,
                                         const ResponseModel& response) {
  std::vector<std::vector<float>> channels(static_cast<std::size_t>(response.rowCount()),
                                           std::vector<float>(parameters.count()));
  std::vector<float*> rows;
  for (std::vector<float>& channel : channels)
    rows.push_back(channel.data());
  response.evaluate(parameters.batch(), rows);
  for (std::size_t i = 0; i < parameters.count(); ++i) {
    if (parameters.present[i]) continue;
    for (std::vector<float>& channel : channels)
      channel[i] = 0.0f;
  }
  return channels;
}

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
  CUTIS_TRY(parameters, loadEdited(skin, rect, step));
  PictureBuffer part = emptyPart(rect, step);
  part.channels = evaluate(parameters, response);
  part.present = std::move(parameters.present);
  return part;
}

Result<PictureBuffer> mapPart(const EditedSkin& skin, Parameter parameter, const Rect& rect,
                              int step) {
  CUTIS_TRY(parameters, loadEdited(skin, rect, step));
  PictureBuffer part = emptyPart(rect, step);
  const std::span<const float> values = parameters.values[static_cast<std::size_t>(parameter)];
  part.channels.emplace_back(values.begin(), values.end());
  part.present = std::move(parameters.present);
  return part;
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
  CUTIS_CHECK(forEachTile(skin.maps, context, [&](const Rect& rect) -> Status {
    CUTIS_TRY(parameters, loadEdited(skin, rect));
    return storeParameters(parameters, rect, edited);
  }));
  return edited;
}

Result<PictureBuffer> editAlbedoPart(PictureBuffer source, const EditedSkin& skin,
                                     const ResponseModel& albedo, bool pure, const Rect& rect,
                                     int step) {
  CUTIS_TRY(parameters, loadParameters(skin.maps, rect, step));
  const std::vector<std::vector<float>> original = evaluate(parameters, albedo);
  CUTIS_CHECK(applyEdits(skin.edits, skin.axes(), rect, step, parameters));
  const std::vector<std::vector<float>> edited = evaluate(parameters, albedo);
  for (std::size_t k = 0; k < source.channels.size(); ++k) {
    std::vector<float>& pixels = source.channels[k];
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (!parameters.present[i]) continue;
      const float model = std::max(original[k][i], kSmallestAlbedo);
      const float changed = std::max(edited[k][i], kSmallestAlbedo);
      if (pure) {
        pixels[i] = edited[k][i];
      } else if (changed != model) {
        pixels[i] *= changed / model;
      }
    }
  }
  return source;
}

}  // namespace cutis
