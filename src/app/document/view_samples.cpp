#include "src/app/document/view_samples.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/base/parallel.h"
#include "src/app/document/picture_bands.h"
#include "src/app/open/photograph_part.h"

namespace cutis {
namespace {

// Rows of samples that one thread computes at a time.
constexpr int kBandRows = 32;

}  // namespace

Result<std::shared_ptr<const ResponseModel>> responseFor(ViewKind view, const Scene& scene,
                                                         Engine& engine,
                                                         const PictureRequest& picture,
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

Result<ViewSamples> ViewSamples::load(const Scene& scene, Engine& engine,
                                      const PictureRequest& picture, const ViewRequest& request,
                                      const JobContext& context) {
  ViewSamples samples;
  samples.request_ = request;
  samples.request_.rect = intersection(request.rect, scene.maps.state.bounds());
  samples.model_ = scene.model;
  CUTIS_TRY(response, responseFor(request.view, scene, engine, picture, context));
  samples.response_ = response;
  samples.table_ = engine.responseTable(response, scene.axes());
  const Rect& rect = samples.request_.rect;
  if (rect.empty()) return samples;
  const int bandHeight = kBandRows * request.step;
  samples.bands_.resize(static_cast<std::size_t>((rect.height() + bandHeight - 1) / bandHeight));
  CUTIS_CHECK(parallelFor(samples.bands_.size(), context, [&](std::size_t i) -> Status {
    const int y0 = rect.y0 + static_cast<int>(i) * bandHeight;
    CUTIS_TRY(band,
              samples.loadBand(scene, {rect.x0, y0, rect.x1, std::min(y0 + bandHeight, rect.y1)}));
    samples.bands_[i] = std::move(band);
    return {};
  }));
  return samples;
}

Result<ViewSamples::Band> ViewSamples::loadBand(const Scene& scene, const Rect& rect) const {
  const bool isPhotograph = request_.view == ViewKind::photograph;
  Band band;
  if (isPhotograph || request_.view == ViewKind::editedAlbedo) {
    CUTIS_TRY(photograph, photographPart(*scene.source, rect, request_.step));
    band.photograph = std::move(photograph);
  }
  if (isPhotograph) return band;
  CUTIS_TRY(skin, loadSamples(scene, rect, request_.step));
  band.skin = std::move(skin);
  if (response_) band.skin.original = responseTo(band.skin.parameters, *response_);
  if (table_) band.skin.tabulated = responseTo(band.skin.parameters, *table_);
  return band;
}

Result<ViewSamples> ViewSamples::thinned(int n, const JobContext& context) const {
  ViewSamples kept;
  kept.request_ = request_;
  kept.request_.step *= n;
  kept.model_ = model_;
  kept.response_ = response_;
  kept.table_ = table_;
  kept.bands_.resize(bands_.size());
  CUTIS_CHECK(parallelFor(bands_.size(), context, [&](std::size_t i) -> Status {
    kept.bands_[i] = {cutis::thinned(bands_[i].skin, n), cutis::thinned(bands_[i].photograph, n)};
    return {};
  }));
  return kept;
}

Result<ViewPart> ViewSamples::render(const EditStack& edits, ViewAccuracy accuracy,
                                     const JobContext& context) const {
  ViewPart part;
  part.request = request_;
  CUTIS_TRY(pixels, joinedBands(bands_.size(), context, [&](std::size_t i) {
              return renderBand(bands_[i], edits, accuracy);
            }));
  part.pixels = std::move(pixels);
  return part;
}

Result<PictureBuffer> ViewSamples::renderBand(const Band& band, const EditStack& edits,
                                              ViewAccuracy accuracy) const {
  const ParameterAxes& axes = model_->profile().axes;
  if (const auto parameter = parameterOf(request_.view))
    return mapSamples(band.skin, edits, axes, *parameter);
  if (request_.view == ViewKind::photograph) return band.photograph;
  const bool isAlbedo = request_.view == ViewKind::editedAlbedo;
  if (accuracy == ViewAccuracy::draft && table_) {
    PictureBuffer unedited = band.photograph;
    if (!isAlbedo) {
      CUTIS_TRY(original, renderSamples(band.skin, {}, axes, *response_));
      unedited = std::move(original);
    }
    return draftSamples(std::move(unedited), band.skin, edits, axes, *table_);
  }
  if (isAlbedo)
    return editAlbedoSamples(band.photograph, band.skin, edits, axes, *response_, false);
  return renderSamples(band.skin, edits, axes, *response_);
}

}  // namespace cutis
