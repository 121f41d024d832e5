#include "src/app/document/view_part.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/skin/parameter_buffer.h"
#include "src/app/open/photograph_part.h"

namespace cutis {
namespace {

// Rows of samples that one thread computes at a time.
constexpr int kBandRows = 32;

// The reduced model a layer needs; null for those that need none.
Result<std::shared_ptr<const ResponseModel>> modelOf(ViewKind layer, const Scene& scene,
                                                     Engine& engine,
                                                     const PictureRequest& picture) {
  PictureRequest request;
  switch (layer) {
    case ViewKind::skin:
      request = picture;
      break;
    case ViewKind::editedAlbedo:
      break;  // under D65
    case ViewKind::ultraviolet:
      request.band = kUltravioletBand;
      break;
    case ViewKind::nearInfrared:
      request.band = kNearInfraredBand;
      break;
    default:
      return std::shared_ptr<const ResponseModel>();
  }
  return engine.picture(scene.model, request, "light");
}

Result<PictureBuffer> mapPart(const Scene& scene, Parameter parameter, const Rect& rect, int step) {
  CUTIS_TRY(parameters, loadParameters(scene.maps, rect, step));
  CUTIS_CHECK(applyEdits(scene.edits, scene.model->profile().axes, rect, step, parameters));
  PictureBuffer part;
  part.width = (rect.width() + step - 1) / step;
  part.height = (rect.height() + step - 1) / step;
  const std::span<const float> values = parameters.values[static_cast<std::size_t>(parameter)];
  part.channels.emplace_back(values.begin(), values.end());
  part.present = std::move(parameters.present);
  return part;
}

Result<PictureBuffer> renderBand(const Scene& scene, const ResponseModel* model, ViewKind layer,
                                 const Rect& rect, int step) {
  const ParameterAxes& axes = scene.model->profile().axes;
  if (const auto parameter = parameterOf(layer)) return mapPart(scene, *parameter, rect, step);
  if (layer == ViewKind::photograph) return photographPart(*scene.source, rect, step);
  if (layer == ViewKind::editedAlbedo) {
    CUTIS_TRY(photograph, photographPart(*scene.source, rect, step));
    return editAlbedoPart(std::move(photograph), scene.maps, scene.edits, axes, *model, false, rect,
                          step);
  }
  return renderPart(scene.maps, scene.edits, axes, *model, rect, step);
}

// Bands of the same width, one below the other.
PictureBuffer joinBands(std::vector<PictureBuffer> bands) {
  PictureBuffer joined = std::move(bands.front());
  for (std::size_t b = 1; b < bands.size(); ++b) {
    const PictureBuffer& band = bands[b];
    joined.height += band.height;
    for (std::size_t c = 0; c < joined.channels.size(); ++c) {
      joined.channels[c].insert(joined.channels[c].end(), band.channels[c].begin(),
                                band.channels[c].end());
    }
    joined.present.insert(joined.present.end(), band.present.begin(), band.present.end());
  }
  return joined;
}

}  // namespace

std::optional<Parameter> parameterOf(ViewKind layer) {
  switch (layer) {
    case ViewKind::melanin:
      return kMelanin;
    case ViewKind::melaninBlend:
      return kMelaninBlend;
    case ViewKind::haemoglobinDermal:
      return kHaemoglobinDermal;
    case ViewKind::haemoglobinEpidermal:
      return kHaemoglobinEpidermal;
    case ViewKind::carotene:
      return kCarotene;
    default:
      return std::nullopt;
  }
}

Result<ViewPart> renderView(const Scene& scene, Engine& engine, const PictureRequest& picture,
                            const ViewRequest& request, const JobContext& context) {
  CUTIS_TRY(model, modelOf(request.layer, scene, engine, picture));
  ViewPart part;
  part.request = request;
  part.request.rect = intersection(request.rect, scene.maps.state.bounds());
  const Rect& rect = part.request.rect;
  if (rect.empty()) return part;
  const int bandHeight = kBandRows * request.step;
  const int count = (rect.height() + bandHeight - 1) / bandHeight;
  std::vector<PictureBuffer> bands(static_cast<std::size_t>(count));
  CUTIS_CHECK(parallelFor(bands.size(), context, [&](std::size_t i) -> Status {
    const int y0 = rect.y0 + static_cast<int>(i) * bandHeight;
    const Rect band = {rect.x0, y0, rect.x1, std::min(y0 + bandHeight, rect.y1)};
    CUTIS_TRY(pixels, renderBand(scene, model.get(), request.layer, band, request.step));
    bands[i] = std::move(pixels);
    return {};
  }));
  part.pixels = joinBands(std::move(bands));
  return part;
}

}  // namespace cutis
