#include "core/render/render_picture.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "core/base/parallel.h"

namespace cutis {
namespace {

// Below this a ratio of two models says nothing; far below the darkest skin in any channel.
constexpr float kSmallestAlbedo = 1e-4f;

PictureBuffer evaluate(const ParameterBuffer& parameters, const ResponseModel& picture) {
  PictureBuffer buffer;
  buffer.present = parameters.present;
  buffer.channels.assign(static_cast<std::size_t>(picture.rowCount()),
                         std::vector<float>(parameters.count()));
  std::vector<float*> rows;
  for (std::vector<float>& channel : buffer.channels)
    rows.push_back(channel.data());
  picture.evaluate(parameters.batch(), rows);
  for (std::size_t i = 0; i < parameters.count(); ++i) {
    if (buffer.present[i]) continue;
    for (std::vector<float>& channel : buffer.channels)
      channel[i] = 0.0f;
  }
  return buffer;
}

std::vector<Plane> makePlanes(int count, const ChromophoreMaps& maps,
                              const std::shared_ptr<TileStore>& store) {
  std::vector<Plane> planes;
  for (int k = 0; k < count; ++k) {
    planes.emplace_back(maps.width(), maps.height(), PixelFormat::float32, store);
  }
  return planes;
}

// Calls work(rect) for each tile of the maps.
Status forEachTile(const ChromophoreMaps& maps, const JobContext& context,
                   const std::function<Status(const Rect&)>& work) {
  const Plane& state = maps.state;
  return parallelFor(static_cast<std::size_t>(state.tileCount()), context,
                     [&](std::size_t i) { return work(state.tileRect(static_cast<int>(i))); });
}

}  // namespace

Result<PictureBuffer> renderPart(const ChromophoreMaps& maps, const EditStack& edits,
                                 const ParameterAxes& axes, const ResponseModel& picture,
                                 const Rect& rect, int step) {
  CUTIS_TRY(parameters, loadParameters(maps, rect, step));
  CUTIS_CHECK(applyEdits(edits, axes, rect, step, parameters));
  PictureBuffer buffer = evaluate(parameters, picture);
  buffer.width = (rect.width() + step - 1) / step;
  buffer.height = (rect.height() + step - 1) / step;
  return buffer;
}

Result<std::vector<Plane>> renderPicture(const ChromophoreMaps& maps, const EditStack& edits,
                                         const ParameterAxes& axes, const ResponseModel& picture,
                                         const std::shared_ptr<TileStore>& store,
                                         const JobContext& context) {
  std::vector<Plane> planes = makePlanes(picture.rowCount(), maps, store);
  CUTIS_CHECK(forEachTile(maps, context, [&](const Rect& rect) -> Status {
    CUTIS_TRY(part, renderPart(maps, edits, axes, picture, rect, 1));
    for (std::size_t k = 0; k < planes.size(); ++k) {
      CUTIS_CHECK(planes[k].store(rect, part.channels[k]));
    }
    return {};
  }));
  return planes;
}

Result<ChromophoreMaps> editMaps(const ChromophoreMaps& maps, const EditStack& edits,
                                 const ParameterAxes& axes, const std::shared_ptr<TileStore>& store,
                                 const JobContext& context) {
  ChromophoreMaps edited(maps.width(), maps.height(), PixelFormat::float32, store);
  edited.state = maps.state;
  edited.constants = maps.constants;
  CUTIS_CHECK(forEachTile(maps, context, [&](const Rect& rect) -> Status {
    CUTIS_TRY(parameters, loadParameters(maps, rect));
    CUTIS_CHECK(applyEdits(edits, axes, rect, 1, parameters));
    return storeParameters(parameters, rect, edited);
  }));
  return edited;
}

Result<PictureBuffer> editAlbedoPart(PictureBuffer source, const ChromophoreMaps& maps,
                                     const EditStack& edits, const ParameterAxes& axes,
                                     const ResponseModel& albedo, bool pure, const Rect& rect,
                                     int step) {
  CUTIS_TRY(edited, renderPart(maps, edits, axes, albedo, rect, step));
  CUTIS_TRY(original, renderPart(maps, {}, axes, albedo, rect, step));
  for (std::size_t k = 0; k < source.channels.size(); ++k) {
    std::vector<float>& pixels = source.channels[k];
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (!edited.present[i]) continue;
      const float model = std::max(original.channels[k][i], kSmallestAlbedo);
      const float changed = std::max(edited.channels[k][i], kSmallestAlbedo);
      if (pure) {
        pixels[i] = edited.channels[k][i];
      } else if (changed != model) {
        pixels[i] *= changed / model;
      }
    }
  }
  return source;
}

Result<std::vector<Plane>> editAlbedo(const std::vector<Plane>& source, const ChromophoreMaps& maps,
                                      const EditStack& edits, const ParameterAxes& axes,
                                      const ResponseModel& albedo, bool pure,
                                      const std::shared_ptr<TileStore>& store,
                                      const JobContext& context) {
  std::vector<Plane> planes = makePlanes(3, maps, store);
  CUTIS_CHECK(forEachTile(maps, context, [&](const Rect& rect) -> Status {
    PictureBuffer part;
    part.channels.assign(planes.size(), std::vector<float>(rect.pixelCount()));
    for (std::size_t k = 0; k < planes.size(); ++k) {
      CUTIS_CHECK(source[k].load(rect, part.channels[k]));
    }
    CUTIS_TRY(edited, editAlbedoPart(std::move(part), maps, edits, axes, albedo, pure, rect, 1));
    for (std::size_t k = 0; k < planes.size(); ++k) {
      CUTIS_CHECK(planes[k].store(rect, edited.channels[k]));
    }
    return {};
  }));
  return planes;
}

}  // namespace cutis
