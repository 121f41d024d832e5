#include "ui/view/view_controller.h"

#include <algorithm>

#include "ui/view/view_catalogue.h"
#include "ui/view/view_strip.h"
#include "ui/view/viewport.h"

namespace cutis {
namespace {

// Samples along the longer side.
constexpr int kThumbnailSize = 160;
constexpr int kOverviewSize = 512;

// The whole picture with at most `size` samples a side.
ViewRequest wholePicture(ViewKind layer, const Scene& scene, int size) {
  const int longer = std::max(scene.width(), scene.height());
  return {layer, {0, 0, scene.width(), scene.height()}, std::max(1, (longer + size - 1) / size)};
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
                                })),
      overviewWatch_(server.watch(ViewPriority::overview, [this](const Part& part) {
        overview_ = part;
        showOverview();
      })) {
  connect(&document, &Document::opened, this, &ViewController::open);
  connect(&document, &Document::sceneReplaced, this, [this] { ranges_.clear(); });
  connect(&viewport, &Viewport::viewChanged, this, &ViewController::wantDetail);
}

ViewController::~ViewController() = default;

void ViewController::attach(ViewStrip& strip) {
  strip_ = &strip;
  connect(&strip, &ViewStrip::chosen, this, [this](const QString& id) {
    if (const auto layer = layerById(id)) show(*layer);
  });
  if (document_.isOpen()) fillStrip();
}

void ViewController::open() {
  const Scene& scene = document_.scene();
  detail_ = nullptr;
  overview_ = nullptr;
  ranges_.clear();
  current_ = scene.source ? ViewKind::photograph : ViewKind::skin;
  fillStrip();
  viewport_.clear();
  viewport_.setPictureSize(scene.width(), scene.height());
  wantDetail();
  wantOverview();
  showColorBar();
  Q_EMIT currentChanged();
}

void ViewController::fillStrip() {
  thumbnailWatches_.clear();
  if (strip_ == nullptr) return;
  QVector<LayerEntry> entries;
  for (const LayerDescription& layer : layerCatalogue()) {
    if (!isOffered(layer.kind)) continue;
    entries.push_back({layer.id, layer.name, layer.toolTip});
    auto watch =
        server_.watch(ViewPriority::thumbnail, [this](const Part& part) { takeThumbnail(part); });
    watch->want(wholePicture(layer.kind, document_.scene(), kThumbnailSize));
    thumbnailWatches_.push_back(std::move(watch));
  }
  strip_->setLayers({});
  strip_->setLayers(entries);
  strip_->setCurrent(describe(current_).id);
}

bool ViewController::isOffered(ViewKind layer) const {
  return document_.isOpen() && (document_.scene().source || !describe(layer).needsSource);
}

void ViewController::show(ViewKind layer) {
  if (!isOffered(layer) || layer == current_) return;
  current_ = layer;
  if (strip_ != nullptr) strip_->setCurrent(describe(layer).id);
  wantDetail();
  wantOverview();
  showColorBar();
  Q_EMIT currentChanged();
}

void ViewController::wantDetail() {
  document_.lookAt(viewport_.visibleRect());
  detailWatch_->want({current_, viewport_.visibleRect(), viewport_.samplingStep()});
}

void ViewController::wantOverview() {
  if (!document_.isOpen()) return;
  overviewWatch_->want(wholePicture(current_, document_.scene(), kOverviewSize));
}

void ViewController::takeThumbnail(const Part& part) {
  takeRange(part);
  strip_->setThumbnail(describe(part->request.layer).id, imageOf(*part));
}

void ViewController::takeRange(const Part& part) {
  const ViewKind layer = part->request.layer;
  const bool edited = !isNeutral(document_.scene().edits);
  if (!describe(layer).scale || (edited && ranges_.contains(layer))) return;
  ranges_[layer] = rangeOf(*part);
  if (layer != current_) return;
  showDetail();
  showOverview();
  showColorBar();
}

void ViewController::showDetail() {
  if (!detail_ || detail_->request.layer != current_) return;
  viewport_.setDetail(imageOf(*detail_), detail_->request.rect, detail_->request.step);
}

void ViewController::showOverview() {
  if (overview_ && overview_->request.layer == current_) viewport_.setOverview(imageOf(*overview_));
}

void ViewController::showColorBar() {
  const LayerDescription& layer = describe(current_);
  if (!layer.scale) return viewport_.setColorBar(std::nullopt);
  const DisplayRange range = ranges_[current_];
  viewport_.setColorBar(
      ColorBarSpec{layer.name, layer.unit, range.minimum, range.maximum, *layer.scale});
}

QImage ViewController::imageOf(const ViewPart& part) const {
  const LayerDescription& layer = describe(part.request.layer);
  if (!layer.scale) return colorImage(part);
  const auto known = ranges_.find(layer.kind);
  return falseColorImage(part, *layer.scale,
                         known == ranges_.end() ? rangeOf(part) : known->second);
}

}  // namespace cutis
