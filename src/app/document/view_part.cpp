#include "src/app/document/view_part.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "src/app/open/photograph_part.h"

namespace cutis {
namespace {

// Rows of samples that one thread computes at a time.
constexpr int kBandRows = 32;

// The reduced model a view needs; null for those that need none.
Result<std::shared_ptr<const ResponseModel>> modelOf(ViewKind view, const Scene& scene,
                                                     Engine& engine, const PictureRequest& picture,
                                                     const JobContext& context) {
  PictureRequest request;
  switch (view) {
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
  CUTIS_TRY(wanted, pictureRows(request, {"light", "observer"}));
  return engine.response(scene.model, wanted.rows, scene.perPixel(), context);
}

Result<PictureBuffer> renderBand(const Scene& scene, const ResponseModel* model, ViewKind view,
                                 const Rect& rect, int step) {
  if (const auto parameter = parameterOf(view)) return mapPart(scene, *parameter, rect, step);
  if (view == ViewKind::photograph) return photographPart(*scene.source, rect, step);
  if (view == ViewKind::editedAlbedo) {
    CUTIS_TRY(photograph, photographPart(*scene.source, rect, step));
    return editAlbedoPart(std::move(photograph), scene, *model, false, rect, step);
  }
  return renderPart(scene, *model, rect, step);
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

std::optional<Parameter> parameterOf(ViewKind view) {
  static_assert(kParameterCount == 5,
                "a sixth has its ViewKind here and its row in ui/view/view_catalogue.cpp");
  switch (view) {
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
  CUTIS_TRY(model, modelOf(request.view, scene, engine, picture, context));
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
    CUTIS_TRY(pixels, renderBand(scene, model.get(), request.view, band, request.step));
    bands[i] = std::move(pixels);
    return {};
  }));
  part.pixels = joinBands(std::move(bands));
  return part;
}

}  // namespace cutis
