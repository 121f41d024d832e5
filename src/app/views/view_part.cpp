#include "src/app/views/view_part.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/render/box_average.h"
#include "src/app/open/photograph_part.h"
#include "src/app/views/picture_bands.h"
#include "src/app/views/view_samples.h"

namespace cutis {
namespace {

// Texels that one thread computes at a time, about.
constexpr int kBandTexels = 1 << 16;

Result<PictureBuffer> everyTexel(const Scene& scene, const ResponseModel* response, ViewKind view,
                                 const Rect& rect) {
  if (isPhotograph(view)) return photographPart(*scene.source, rect, 1, lightOf(view).value_or(0));
  if (view != ViewKind::editedAlbedo) return renderPart(scene, *response, rect, 1);
  CUTIS_TRY(photograph, photographPart(*scene.source, rect, 1));
  return editAlbedoPart(std::move(photograph), scene, *response, false, rect, 1);
}

}  // namespace

Result<ViewPart> renderAveraged(const Scene& scene, Engine& engine, const PictureRequest& picture,
                                const ViewRequest& request, const JobContext& context) {
  ViewPart part;
  part.request = request;
  part.request.rect = intersection(request.rect, scene.maps.state.bounds());
  CUTIS_TRY(response, responseFor(request, scene, engine, picture, context));
  const Rect& rect = part.request.rect;
  if (rect.empty()) return part;
  const int step = request.step;
  const int bandHeight = step * std::max(1, kBandTexels / (rect.width() * step));
  const auto count = static_cast<std::size_t>((rect.height() + bandHeight - 1) / bandHeight);
  const auto band = [&](std::size_t i) -> Result<PictureBuffer> {
    const int y0 = rect.y0 + static_cast<int>(i) * bandHeight;
    const Rect rows = {rect.x0, y0, rect.x1, std::min(y0 + bandHeight, rect.y1)};
    CUTIS_TRY(texels, everyTexel(scene, response.get(), request.view, rows));
    return boxAverage(texels, step);
  };
  CUTIS_TRY(pixels, joinedBands(count, context, band));
  part.pixels = std::move(pixels);
  return part;
}

}  // namespace cutis
