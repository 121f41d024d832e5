#include "ui/view/view_controller.h"

#include <algorithm>
#include <utility>

#include "ui/view/view_catalogue.h"
#include "ui/view/view_strip.h"
#include "ui/view/viewport.h"

namespace cutis {
namespace {

// Samples along the longer side.
constexpr int kThumbnailSize = 160;
constexpr int kOverviewSize = 512;
constexpr int kHeights = 60;  // columns of the spread of values

bool isWithoutEstimate(const ViewPart& part) {
  const auto& present = part.pixels.present;
  return std::none_of(present.begin(), present.end(), [](auto is) { return bool{is != 0}; });
}

// A map shows one parameter, bands show what all of them make.
bool changesView(const EditStack& edits, ViewKind view) {
  if (isPhotograph(view) || isJudgement(view) || constantOf(view)) return false;
  const auto parameter = parameterOf(view);
  if (!parameter) return !isNeutral(edits);
  return std::any_of(edits.begin(), edits.end(), [&](const Edit& edit) {
    return edit.enabled && !edit.parameters[static_cast<std::size_t>(*parameter)].isNeutral();
  });
}

}  // namespace

ViewController::ViewController(Document& document, ViewServer& server, Viewport& viewport,
                               QObject* parent)
    : QObject(parent),
      document_(document),
      server_(server),
      viewport_(viewport),
      detailWatch_(server.watch(ViewPriority::detail,
                                [this](const Part& part) {
                                  detail_ = part;
                                  showDetail();
                                  Q_EMIT partShown();
                                })),
      overviewWatch_(server.watch(ViewPriority::overview, [this](const Part& part) {
        overview_ = part;
        showOverview();
        Q_EMIT partShown();
      })) {
  connect(&document, &Document::opened, this, &ViewController::open);
  connect(&document, &Document::previewed, this, &ViewController::showPreview);
  connect(&document, &Document::previewRefined, this, &ViewController::refinePreview);
  connect(&document, &Document::previewEnded, this, &ViewController::endPreview);
  connect(&document, &Document::sceneReplaced, this, [this] {
    ranges_.clear();
    refillStrip();
    showColorBar();
  });
  connect(&viewport, &Viewport::rangeMoved, this, [this](const DisplayRange& range) {
    fixed_[current_] = range;
    showRange();
  });
  connect(&viewport, &Viewport::automaticRangeWanted, this, &ViewController::makeRangeAutomatic);
  connect(&document, &Document::fitChoiceChanged, this, &ViewController::showColorBar);
  connect(&document, &Document::fitted, this, &ViewController::takeSkinValues);
  connect(&document, &Document::editsChanged, this, &ViewController::showColorBar);
  connect(&viewport.bandScrubber(), &BandScrubber::wavelengthChosen, this,
          &ViewController::showBand);
  connect(&viewport, &Viewport::viewChanged, this, &ViewController::wantDetail);
}

ViewController::~ViewController() = default;

void ViewController::attach(ViewStrip& strip) {
  strip_ = &strip;
  connect(&strip, &ViewStrip::chosen, this, [this](const QString& id) {
    if (const auto view = viewById(id)) show(*view);
  });
  if (document_.isOpen()) fillStrip();
}

void ViewController::showPreview(const SourcePreview& preview) {
  preview_ = colorImage(preview.picture);
  viewport_.clear();
  viewport_.setPictureSize(preview.width, preview.height);
  viewport_.setOverview(preview_);
}

void ViewController::refinePreview(const SourcePreview& preview) {
  preview_ = colorImage(preview.picture);
  viewport_.setOverview(preview_);
}

void ViewController::endPreview() {
  preview_ = {};
  viewport_.clear();
}

void ViewController::open() {
  const Scene& scene = document_.scene();
  if (strip_ != nullptr) strip_->setViews({});
  detail_ = nullptr;
  overview_ = nullptr;
  thumbnails_.clear();
  firstPicture_ = {};
  ranges_.clear();
  fixed_.clear();
  current_ = scene.source ? ViewKind::photograph : ViewKind::skin;
  fillStrip();
  viewport_.clear();
  viewport_.setPictureSize(scene.width(), scene.height());
  // The first impression stays until there is more.
  if (!preview_.isNull()) viewport_.setOverview(std::exchange(preview_, {}));
  wantDetail();
  wantOverview();
  takeSkinValues();
  Q_EMIT currentChanged();
}

void ViewController::fillStrip() {
  thumbnailWatches_.clear();
  if (strip_ == nullptr) return;
  QVector<ViewEntry> entries;
  offered_ = offeredViews();
  for (const ViewKind kind : offered_) {
    const ViewDescription& view = describe(kind);
    entries.push_back({view.id, viewName(view.kind, document_), view.toolTip, view.group});
    thumbnailWatches_[view.kind] =
        server_.watch(ViewPriority::thumbnail, [this](const Part& part) { takeThumbnail(part); });
  }
  watchThumbnails();
  strip_->setViews(entries);
  strip_->setCurrent(describe(current_).id);
}

// Another fit may know more of its pixels, or less.
void ViewController::refillStrip() {
  if (!isOffered(current_)) show(ViewKind::melanin);
  if (offered_ != offeredViews()) fillStrip();
}

std::vector<ViewKind> ViewController::offeredViews() const {
  std::vector<ViewKind> views;
  for (const ViewDescription& view : viewCatalogue()) {
    if (isOffered(view.kind)) views.push_back(view.kind);
  }
  return views;
}

void ViewController::watchThumbnails() {
  for (const auto& [kind, watch] : thumbnailWatches_) {
    watch->setSeen(stripSeen_ || (kind == current_ && describe(kind).scale));
    watch->want(wholePicture(kind, kThumbnailSize));
  }
}

void ViewController::setStripSeen(bool seen) {
  stripSeen_ = seen;
  watchThumbnails();
}

bool ViewController::isOffered(ViewKind view) const {
  return document_.isOpen() && canShow(document_.scene(), view);
}

void ViewController::show(ViewKind view) {
  if (!isOffered(view) || view == current_) return;
  current_ = view;
  if (strip_ != nullptr) strip_->setCurrent(describe(view).id);
  wantDetail();
  wantOverview();
  watchThumbnails();
  showColorBar();
  Q_EMIT currentChanged();
}

ViewRequest ViewController::wholePicture(ViewKind view, int size) const {
  const Scene& scene = document_.scene();
  const int longer = std::max(scene.width(), scene.height());
  return {view,
          {0, 0, scene.width(), scene.height()},
          std::max(1, (longer + size - 1) / size),
          0,
          viewport_.bandScrubber().wavelengthNm()};
}

PixelMarks ViewController::wantedMarks() const {
  return describe(current_).scale ? marks_ : PixelMarks{0};
}

void ViewController::setAdjustment(const ViewAdjustment& adjustment) {
  if (adjustment == adjustment_) return;
  adjustment_ = adjustment;
  curve_ = DisplayCurve(adjustment);
  showDetail();
  showOverview();
  Q_EMIT adjustmentChanged();
}

void ViewController::setMarked(PixelMark mark, bool on) {
  marks_ = static_cast<PixelMarks>(on ? marks_ | mark : marks_ & ~mark);
  wantDetail();
  showColorBar();
}

void ViewController::wantDetail() {
  if (!document_.isOpen()) return;
  document_.lookAt(viewport_.visibleRect());
  detailWatch_->want(detailRequest());
}

ViewRequest ViewController::detailRequest() const {
  return {current_, viewport_.visibleRect(), viewport_.samplingStep(), wantedMarks(),
          viewport_.bandScrubber().wavelengthNm()};
}

ViewRequest ViewController::overviewRequest() const {
  return wholePicture(current_, kOverviewSize);
}

void ViewController::wantOverview() {
  if (!document_.isOpen()) return;
  overviewWatch_->want(overviewRequest());
}

void ViewController::showBand() {
  if (current_ != ViewKind::band) return;
  wantDetail();
  wantOverview();
  watchThumbnails();
}

void ViewController::takeThumbnail(const Part& part) {
  thumbnails_[part->request.view] = part;
  takeRange(part);
  showThumbnail(part->request.view);
}

void ViewController::showThumbnail(ViewKind view) {
  const auto known = thumbnails_.find(view);
  if (strip_ == nullptr || known == thumbnails_.end()) return;
  const bool isEmpty = awaitsEstimate(view) || isWithoutEstimate(*known->second);
  strip_->setThumbnail(describe(view).id,
                       isEmpty ? QImage() : imageOf(*known->second, DisplayCurve::neutral()));
}

void ViewController::takeRange(const Part& part) {
  const ViewKind view = part->request.view;
  const bool edited = !isNeutral(document_.scene().edits);
  if (!describe(view).scale || awaitsEstimate(view) || (edited && ranges_.contains(view))) return;
  if (skinValuesOf(view) != nullptr) return;
  const auto range = rangeOf(*part);
  if (!range) return;
  ranges_[view] = *range;
  if (view == current_) showRange();
}

const std::vector<float>* ViewController::skinValuesOf(ViewKind view) const {
  const auto parameter = parameterOf(view);
  const auto values = document_.skinValues();
  if (!parameter || !values) return nullptr;
  const auto& sorted = values->sorted[static_cast<std::size_t>(*parameter)];
  return sorted.empty() ? nullptr : &sorted;
}

void ViewController::takeSkinValues() {
  for (const ViewDescription& view : viewCatalogue()) {
    if (const auto* values = skinValuesOf(view.kind))
      ranges_[view.kind] = rangeOfValues(*values, logarithmic_.contains(view.kind));
    showThumbnail(view.kind);
  }
  showRange();
  watchThumbnails();
}

void ViewController::makeRangeAutomatic() {
  if (fixed_.erase(current_) > 0) showRange();
}

bool ViewController::canBeLogarithmic() const {
  return document_.isOpen() && skinValuesOf(current_) != nullptr;
}

void ViewController::setLogarithmic(bool isLogarithmic) {
  if (!canBeLogarithmic()) return;
  if (isLogarithmic) {
    logarithmic_.insert(current_);
  } else {
    logarithmic_.erase(current_);
  }
  fixed_.erase(current_);
  takeSkinValues();
}

const DisplayRange* ViewController::knownRange(ViewKind view) const {
  if (const auto fixed = fixed_.find(view); fixed != fixed_.end()) return &fixed->second;
  const auto known = ranges_.find(view);
  return known == ranges_.end() ? nullptr : &known->second;
}

void ViewController::showRange() {
  showThumbnail(current_);
  showDetail();
  showOverview();
  showColorBar();
  Q_EMIT rangeChanged();
}

void ViewController::showDetail() {
  if (!detail_ || detail_->request.view != current_) return;
  viewport_.setDetail(imageOf(*detail_), detail_->request.rect, detail_->request.step);
  viewport_.setMarks({detail_->marks, detail_->request.rect, detail_->request.step});
}

void ViewController::showOverview() {
  if (!overview_ || overview_->request.view != current_) return;
  const QImage image = imageOf(*overview_);
  viewport_.setOverview(image);
  if (!firstPicture_.isNull() || describe(current_).scale) return;
  firstPicture_ = imageOf(*overview_, DisplayCurve::neutral());
  Q_EMIT firstPictureSeen();
}

bool ViewController::awaitsEstimate(ViewKind view) const {
  const bool showsSource = isPhotograph(view) || view == ViewKind::editedAlbedo;
  return document_.isOpen() && !document_.hasEstimate() && !showsSource;
}

void ViewController::setBarInstead(const std::optional<ColorBarSpec>& spec) {
  barInstead_ = spec;
  showColorBar();
}

void ViewController::showColorBar() {
  if (!document_.isOpen()) return;
  const ViewDescription& view = describe(current_);
  const bool awaits = awaitsEstimate(current_);
  viewport_.bandScrubber().setWanted(current_ == ViewKind::band && !awaits);
  viewport_.setNotice(awaits ? tr("Not fitted yet") : QString());
  if (barInstead_) return viewport_.setColorBar(barInstead_);
  if (!view.scale || awaits) return viewport_.setColorBar(std::nullopt);
  ColorBarSpec spec = {view.name, view.unit, {}, *view.scale, stateText(), false};
  if (const DisplayRange* known = knownRange(current_)) {
    spec.range = *known;
    spec.isKnown = true;
    if (const auto* values = skinValuesOf(current_)) {
      spec.axis = axisAround(spec.range, *values);
      spec.heights = heightsAlong(*spec.axis, *values, kHeights);
    }
  }
  if (document_.scene().evidence != nullptr) spec.marks = marks_;
  viewport_.setColorBar(spec);
}

QString ViewController::stateText() const {
  const bool isIncomplete = !document_.isFitted() && !document_.isFitting();
  if (!ranges_.contains(current_) && !document_.isFitted()) return tr("Not fitted yet");
  if (isIncomplete) return tr("Incomplete");
  if (changesView(document_.scene().edits, current_)) return tr("Edited");
  return isLogarithmic() ? tr("Logarithmic") : QString();
}

QImage ViewController::imageOf(const ViewPart& part) const {
  return imageOf(part, curve_);
}

QImage ViewController::imageOf(const ViewPart& part, const DisplayCurve& curve) const {
  const ViewDescription& view = describe(part.request.view);
  if (awaitsEstimate(view.kind)) return maskedImage(part);
  if (!view.scale) return colorImage(part.pixels, curve);
  const DisplayRange* known = knownRange(view.kind);
  return falseColorImage(part, *view.scale,
                         known ? *known : rangeOf(part).value_or(DisplayRange()));
}

}  // namespace cutis
