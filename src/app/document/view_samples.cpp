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

std::size_t bandCount(const Rect& rect, int step) {
  const int height = kBandRows * step;
  return static_cast<std::size_t>((rect.height() + height - 1) / height);
}

Rect bandOf(const Rect& rect, int step, std::size_t i) {
  const int height = kBandRows * step;
  const int y0 = rect.y0 + static_cast<int>(i) * height;
  return {rect.x0, y0, rect.x1, std::min(y0 + height, rect.y1)};
}

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
                                      const std::shared_ptr<const ViewSkin>& read,
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
  if (request.view != ViewKind::photograph) {
    samples.skin_ = read;
    if (read == nullptr || read->rect != rect || read->step != request.step) {
      CUTIS_TRY(skin, readSkin(scene, rect, request.step, context));
      samples.skin_ = skin;
    }
  }
  samples.bands_.resize(bandCount(rect, request.step));
  CUTIS_CHECK(parallelFor(samples.bands_.size(), context, [&](std::size_t i) -> Status {
    CUTIS_TRY(band, samples.loadBand(scene, i));
    samples.bands_[i] = std::move(band);
    return {};
  }));
  return samples;
}

Result<std::shared_ptr<const ViewSkin>> ViewSamples::readSkin(const Scene& scene, const Rect& rect,
                                                              int step, const JobContext& context) {
  auto skin = std::make_shared<ViewSkin>();
  skin->rect = rect;
  skin->step = step;
  skin->bands.resize(bandCount(rect, step));
  CUTIS_CHECK(parallelFor(skin->bands.size(), context, [&](std::size_t i) -> Status {
    CUTIS_TRY(band, loadSamples(scene, bandOf(rect, step, i), step));
    skin->bands[i] = std::move(band);
    return {};
  }));
  return std::shared_ptr<const ViewSkin>(std::move(skin));
}

Result<ViewSamples::Band> ViewSamples::loadBand(const Scene& scene, std::size_t i) const {
  const Rect rect = bandOf(request_.rect, request_.step, i);
  const bool isPhotograph = request_.view == ViewKind::photograph;
  Band band;
  if (isPhotograph || request_.view == ViewKind::editedAlbedo) {
    CUTIS_TRY(photograph, photographPart(*scene.source, rect, request_.step));
    band.photograph = std::move(photograph);
  }
  if (isPhotograph) return band;
  band.skin = skin_->bands[i];
  if (response_) band.skin.original = responseTo(*band.skin.parameters, *response_);
  if (table_) band.skin.tabulated = responseTo(*band.skin.parameters, *table_);
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
    const Band& band = bands_[i];
    if (skin_ != nullptr) kept.bands_[i].skin = cutis::thinned(band.skin, n);
    kept.bands_[i].photograph = cutis::thinned(band.photograph, n);
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
