#include "ui/inspector/distribution_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/analyse/skin_locus.h"
#include "core/spectra/colorimetry.h"
#include "core/spectra/rgb_primaries.h"
#include "src/files/spectral_library.h"
#include "ui/inspector/distribution_panel.h"
#include "ui/inspector/histogram_counts.h"
#include "ui/plot/histogram_plot.h"
#include "ui/plot/locus_plot.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"

namespace cutis {
namespace {

QPointF placeOf(const Eigen::Vector3d& rec709) {
  static const Eigen::Matrix3d toXyz = xyzFromRec709(kRec709.xyzOfWhite());
  const Eigen::Vector2d color = chromaticityOf(toXyz * rec709);
  return {color[0], color[1]};
}

std::vector<QPointF> placesOf(const PictureBuffer& picture) {
  std::vector<QPointF> places;
  const auto& c = picture.channels;
  for (std::size_t i = 0; i < picture.present.size(); ++i) {
    const QPointF place = placeOf({c[0][i], c[1][i], c[2][i]});
    if (picture.present[i] && std::isfinite(place.x()) && std::isfinite(place.y()))
      places.push_back(place);
  }
  return places;
}

// The other parameters in the middle of what the picture's skin has; without any, of their ranges.
ParameterVector middleOf(const SkinValues* skin, const ParameterAxes& axes) {
  ParameterVector middle;
  for (const Parameter k : kParameters) {
    const auto row = static_cast<std::size_t>(k);
    const bool isKnown = skin != nullptr && !skin->sorted[row].empty();
    middle[k] =
        isKnown ? double{skin->sorted[row][skin->sorted[row].size() / 2]} : 0.1 * axes[row].maximum;
  }
  return middle;
}

std::vector<LocusCurve> curvesOf(const std::vector<LocusLine>& lines) {
  std::vector<LocusCurve> curves;
  for (const LocusLine& line : lines) {
    LocusCurve curve;
    curve.isMelanin = line.parameter == kMelanin;
    for (const Eigen::Vector2d& point : line.points)
      curve.points.emplace_back(point[0], point[1]);
    curves.push_back(curve);
  }
  return curves;
}

}  // namespace

DistributionController::DistributionController(Document& document, JobRunner& jobs,
                                               ViewServer& server, ViewController& views,
                                               Viewport& viewport)
    : document_(document),
      server_(server),
      views_(views),
      sheetJob_(jobs),
      watch_(
          server.watch(ViewPriority::thumbnail, [this](const Part& part) { showColors(part); })) {
  watch_->setSeen(false);
  connect(&document, &Document::opened, this, &DistributionController::refresh);
  connect(&document, &Document::fitted, this, &DistributionController::makeSheet);
  connect(&document, &Document::sceneReplaced, this, &DistributionController::wantColors);
  connect(&views, &ViewController::partShown, this, &DistributionController::showHistogram);
  connect(&views, &ViewController::currentChanged, this, &DistributionController::showHistogram);
  connect(&viewport, &Viewport::cursorMoved, this, &DistributionController::pointAt);
  connect(&viewport, &Viewport::cursorLeft, this, [this] {
    if (panel_ != nullptr) panel_->locus().setCursor({});
  });
}

DistributionController::~DistributionController() = default;

void DistributionController::attach(DistributionPanel& panel) {
  panel_ = &panel;
}

void DistributionController::setSeen(bool seen) {
  seen_ = seen;
  watch_->setSeen(seen);
  refresh();
}

void DistributionController::refresh() {
  if (panel_ == nullptr || !seen_) return;
  wantColors();
  makeSheet();
  showHistogram();
}

void DistributionController::wantColors() {
  if (!document_.isOpen()) return;
  ViewRequest request = views_.overviewRequest();
  const bool hasPhotograph = document_.scene().source != nullptr;
  request.view = hasPhotograph ? ViewKind::photograph : ViewKind::skin;
  watch_->want(request);
}

void DistributionController::showHistogram() {
  if (panel_ == nullptr || !seen_ || !document_.isOpen()) return;
  const Part& part = views_.overview();
  if (part == nullptr || part->request.view != views_.current()) return;
  const Scene& scene = document_.scene();
  const auto pixels =
      static_cast<std::size_t>(scene.width()) * static_cast<std::size_t>(scene.height());
  panel_->setHistogram(histogramOf(*part, describe(views_.current()),
                                   viewName(views_.current(), document_), pixels));
}

void DistributionController::showColors(const Part& part) {
  colors_ = part;
  if (panel_ != nullptr && part->pixels.channels.size() == 3)
    panel_->locus().setColors(placesOf(part->pixels));
}

void DistributionController::makeSheet() {
  if (panel_ == nullptr || !seen_ || !document_.isOpen() || !document_.isFitted()) return;
  const auto skin = document_.skinValues();
  const std::shared_ptr<const SkinModel> model = document_.scene().model;
  sheetJob_.request([this, model, skin](const JobContext&) -> std::function<void()> {
    const auto light = loadLight({"D65", {}, "D65"});
    const auto observer = loadCamera({"cie1931", {}, "cie1931"});
    if (!light || !observer) return [] {};
    const auto lines = skinLocus(*model, middleOf(skin.get(), model->profile().axes),
                                 tristimulusRows(light.value(), observer.value().sensor));
    return [this, curves = curvesOf(lines)] { panel_->locus().setSheet(curves); };
  });
}

// Of the picture that the locus shows, the sample nearest to the cursor.
void DistributionController::pointAt(int x, int y) {
  if (panel_ == nullptr || !seen_ || colors_ == nullptr) return;
  const PictureBuffer& picture = colors_->pixels;
  const int step = colors_->request.step;
  const int column = std::min(x / step, picture.width - 1);
  const int row = std::min(y / step, picture.height - 1);
  const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                 static_cast<std::size_t>(column);
  if (picture.channels.size() != 3) return;
  const auto& c = picture.channels;
  panel_->locus().setCursor(placeOf({c[0][i], c[1][i], c[2][i]}));
}

}  // namespace cutis
