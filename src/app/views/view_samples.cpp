#include "src/app/views/view_samples.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/base/parallel.h"
#include "src/app/open/photograph_part.h"
#include "src/app/views/picture_bands.h"

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

using Tools = std::shared_ptr<const FitEvidence::Tools>;

// Null where nobody wants them. A view without its marks is still a view, but not one that is made
// of nothing else.
Result<Tools> toolsFor(const Scene& scene, Engine& engine, const ViewRequest& request,
                       const JobContext& context) {
  const bool isNeeded = isJudgement(request.view);
  if ((request.marks == 0 && !isNeeded) || scene.evidence == nullptr) return Tools();
  auto tools = scene.evidence->tools(engine, context);
  if (tools.failed() && !isNeeded) return Tools();
  if (tools && tools.value()->solver->valueCount() != scene.maps.planes().size()) return Tools();
  return tools;
}

// One channel, where there is an estimate.
PictureBuffer pictureOf(const SkinSamples& skin, std::vector<float> values) {
  PictureBuffer picture;
  picture.width = skin.width();
  picture.height = skin.height();
  picture.present = skin.parameters->present;
  picture.channels.push_back(std::move(values));
  return picture;
}

// Of a constant that is free.
std::vector<float> rowOf(const ParameterBuffer& buffer, const FreeConstants& free,
                         SkinConstant constant) {
  const bool isSecond = constant == kThickness && free.oxygenation;
  const auto row = buffer.values[kParameterCount + (isSecond ? 1 : 0)];
  return {row.begin(), row.end()};
}

PictureBuffer judgement(const FittedSamples& fitted, ViewKind view, const SkinSamples& skin) {
  if (const auto parameter = deviationOf(view))
    return pictureOf(skin, fitted.deviations(*parameter));
  if (view == ViewKind::shading) return pictureOf(skin, fitted.shading());
  const std::vector<double> misfits = fitted.misfits();
  return pictureOf(skin, std::vector<float>(misfits.begin(), misfits.end()));
}

// Every n-th of rows of so many samples.
std::vector<PixelMarks> thinnedMarks(const std::vector<PixelMarks>& marks, int width, int n) {
  std::vector<PixelMarks> kept;
  const auto columns = static_cast<std::size_t>(width);
  const auto step = static_cast<std::size_t>(n);
  for (std::size_t row = 0; row < marks.size(); row += step * columns) {
    for (std::size_t x = 0; x < columns; x += step)
      kept.push_back(marks[row + x]);
  }
  return kept;
}

}  // namespace

Result<std::shared_ptr<const ResponseModel>> responseFor(const ViewRequest& wanted,
                                                         const Scene& scene, Engine& engine,
                                                         const PictureRequest& picture,
                                                         const JobContext& context) {
  PictureRequest request;
  switch (wanted.view) {
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
    case ViewKind::band:
      request.band = bandBetween(wanted.wavelengthNm, wanted.wavelengthNm);
      break;
    default:
      return std::shared_ptr<const ResponseModel>();
  }
  CUTIS_TRY(rows, pictureRows(request, {"light", "observer"}));
  return engine.response(scene.model, rows.rows, scene.perPixel(), context);
}

Result<ViewSamples> ViewSamples::load(const Scene& scene, Engine& engine,
                                      const PictureRequest& picture, const ViewRequest& request,
                                      const std::shared_ptr<const ViewSkin>& read,
                                      const JobContext& context) {
  ViewSamples samples;
  samples.request_ = request;
  samples.request_.rect = intersection(request.rect, scene.maps.state.bounds());
  samples.model_ = scene.model;
  CUTIS_TRY(response, responseFor(request, scene, engine, picture, context));
  samples.response_ = response;
  // One wavelength is exact in no time, and many are looked at once.
  if (request.view != ViewKind::band) samples.table_ = engine.responseTable(response, scene.axes());
  const Rect& rect = samples.request_.rect;
  if (rect.empty()) return samples;
  if (!isPhotograph(request.view) || request.marks != 0) {
    samples.skin_ = read;
    if (read == nullptr || read->rect != rect || read->step != request.step) {
      CUTIS_TRY(skin, readSkin(scene, rect, request.step, context));
      samples.skin_ = skin;
    }
  }
  CUTIS_TRY(tools, toolsFor(scene, engine, request, context));
  samples.bands_.resize(bandCount(rect, request.step));
  CUTIS_CHECK(parallelFor(samples.bands_.size(), context, [&](std::size_t i) -> Status {
    CUTIS_TRY(band, samples.loadBand(scene, tools.get(), i));
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

Result<ViewSamples::Band> ViewSamples::loadBand(const Scene& scene, const FitEvidence::Tools* tools,
                                                std::size_t i) const {
  const Rect rect = bandOf(request_.rect, request_.step, i);
  const bool isMeasured = isPhotograph(request_.view);
  Band band;
  if (isMeasured || request_.view == ViewKind::editedAlbedo) {
    CUTIS_TRY(photograph, photographPart(*scene.source, rect, request_.step,
                                         lightOf(request_.view).value_or(0)));
    band.picture = std::move(photograph);
  }
  if (skin_ == nullptr) return band;
  band.skin = skin_->bands[i];
  if (tools != nullptr) {
    CUTIS_TRY(fitted, FittedSamples::load(*tools, scene.evidence->measurements(), rect,
                                          request_.step, *band.skin.parameters));
    band.marks = fitted.marks(request_.marks, parameterOf(request_.view));
    if (isJudgement(request_.view)) band.picture = judgement(fitted, request_.view, band.skin);
  }
  if (const auto constant = constantOf(request_.view))
    band.picture = pictureOf(band.skin, rowOf(*band.skin.parameters, scene.maps.free(), *constant));
  if (isMeasured) return band;
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
  const int columns = (request_.rect.width() + request_.step - 1) / request_.step;
  CUTIS_CHECK(parallelFor(bands_.size(), context, [&](std::size_t i) -> Status {
    const Band& band = bands_[i];
    if (skin_ != nullptr) kept.bands_[i].skin = cutis::thinned(band.skin, n);
    kept.bands_[i].picture = cutis::thinned(band.picture, n);
    kept.bands_[i].marks = thinnedMarks(band.marks, columns, n);
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
  part.marks = marks();
  return part;
}

std::vector<PixelMarks> ViewSamples::marks() const {
  std::vector<PixelMarks> all;
  for (const Band& band : bands_)
    all.insert(all.end(), band.marks.begin(), band.marks.end());
  return all;
}

Result<PictureBuffer> ViewSamples::renderBand(const Band& band, const EditStack& edits,
                                              ViewAccuracy accuracy) const {
  const ParameterAxes& axes = model_->profile().axes;
  if (const auto parameter = parameterOf(request_.view))
    return mapSamples(band.skin, edits, axes, *parameter);
  const bool isFixed = isPhotograph(request_.view) || isJudgement(request_.view) ||
                       constantOf(request_.view).has_value();
  if (isFixed) return band.picture;
  const bool isAlbedo = request_.view == ViewKind::editedAlbedo;
  if (accuracy == ViewAccuracy::draft && table_) {
    PictureBuffer unedited = band.picture;
    if (!isAlbedo) {
      CUTIS_TRY(original, renderSamples(band.skin, {}, axes, *response_));
      unedited = std::move(original);
    }
    return draftSamples(std::move(unedited), band.skin, edits, axes, *table_);
  }
  if (isAlbedo) return editAlbedoSamples(band.picture, band.skin, edits, axes, *response_, false);
  return renderSamples(band.skin, edits, axes, *response_);
}

}  // namespace cutis
