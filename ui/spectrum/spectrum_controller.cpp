#include "ui/spectrum/spectrum_controller.h"

#include <utility>

#include <QFontDatabase>
#include <QFontMetrics>

#include "ui/plot/spectrum_plot.h"
#include "ui/spectrum/pixel_readout.h"
#include "ui/spectrum/place_curves.h"
#include "ui/spectrum/spectrum_panel.h"
#include "ui/view/viewport.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

// Of the strip; the rest is left to jobs and messages.
constexpr double kReadoutShare = 0.6;

}  // namespace

SpectrumController::SpectrumController(Document& document, JobRunner& jobs, Viewport& viewport,
                                       ProgressStrip& progress)
    : document_(document), progress_(progress), job_(jobs) {
  connect(&viewport, &Viewport::cursorMoved, this, &SpectrumController::pointAt);
  connect(&viewport, &Viewport::cursorLeft, this, &SpectrumController::leave);
  connect(&document, &Document::opened, this, &SpectrumController::forget);
  connect(&document, &Document::mapsChanged, this, &SpectrumController::refresh);
  connect(&document, &Document::sceneReplaced, this, &SpectrumController::refresh);
  connect(&document, &Document::editsChanged, this, &SpectrumController::refresh);
  connect(&document, &Document::pinsChanged, this, &SpectrumController::refresh);
}

void SpectrumController::attach(SpectrumPanel& panel) {
  panel_ = &panel;
  connect(panel_, &SpectrumPanel::quantityChosen, this, &SpectrumController::setQuantity);
}

void SpectrumController::pointAt(int x, int y) {
  pixel_ = QPoint(x, y);
  isPointedAt_ = true;
  refresh();
}

// The strip is that of all documents: one that is not pointed at leaves it alone.
void SpectrumController::leave() {
  if (std::exchange(isPointedAt_, false)) progress_.setReadout({});
}

void SpectrumController::forget() {
  pixel_.reset();
  job_.cancel();
  if (panel_ != nullptr) panel_->plot().clear();
  leave();
}

void SpectrumController::setSeen(bool seen) {
  if (seen == seen_) return;
  seen_ = seen;
  if (seen && pixel_) plotSpectra(*pixel_);
}

void SpectrumController::refresh() {
  if (!pixel_) return;
  if (isPointedAt_) showReadout(*pixel_, std::nullopt);
  if (seen_) plotSpectra(*pixel_);
}

void SpectrumController::showReadout(const QPoint& pixel,
                                     const std::optional<ParameterVector>& deviation) {
  const QString text = pixelReadout(document_, pixel, deviation);
  const QFontMetrics font(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  const int room = static_cast<int>(kReadoutShare * progress_.width());
  progress_.setReadout(font.elidedText(text, Qt::ElideRight, room));
}

void SpectrumController::setQuantity(SpectrumQuantity quantity) {
  quantity_ = quantity;
  panel_->plot().setParts(quantity);
  refresh();
}

void SpectrumController::plotSpectra(const QPoint& pixel) {
  if (panel_ == nullptr || !document_.isOpen()) return;
  job_.request([this, pixel, scene = document_.scene(), choice = document_.fitChoice(),
                size = document_.pins().size,
                quantity = quantity_](const JobContext&) -> std::function<void()> {
    const SceneSpectra spectra(scene, choice);
    Shown shown = {pixel, size, spectra.measured(), spectra.mean(pixel.x(), pixel.y(), size)};
    if (shown.place) shown.parts = partCurves(*scene.model, *shown.place, quantity);
    return [this, shown, quantity] {
      if (quantity == quantity_) show(shown);
    };
  });
}

void SpectrumController::show(const Shown& shown) {
  SpectrumPlot& plot = panel_->plot();
  plot.setMeasured(shown.measured);
  plot.setParts(quantity_, shown.parts);
  if (!shown.place) return plot.clearPlace();
  if (isPointedAt_ && pixel_ == shown.pixel && shown.size == 1)
    showReadout(shown.pixel, shown.place->parameterDeviation);
  const QString at = tr("pixel %1, %2").arg(shown.pixel.x()).arg(shown.pixel.y());
  plot.setPlace(shown.size == 1 ? at : tr("mean of %1 × %1 about %2").arg(shown.size).arg(at),
                placeCurves(*shown.place), measuredChannels(*shown.place));
}

}  // namespace cutis
