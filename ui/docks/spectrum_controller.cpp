#include "ui/docks/spectrum_controller.h"

#include <utility>

#include <QFontDatabase>
#include <QFontMetrics>
#include <QVector>

#include "ui/docks/pixel_readout.h"
#include "ui/plot/spectrum_plot.h"
#include "ui/view/viewport.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

// Of the strip; the rest is left to jobs and messages.
constexpr double kLargestShare = 0.6;

QVector<double> toVector(const Spectrum& spectrum) {
  return QVector<double>(spectrum.data(), spectrum.data() + spectrum.size());
}

}  // namespace

SpectrumController::SpectrumController(Document& document, Viewport& viewport, SpectrumPlot& plot,
                                       ProgressStrip& progress, QObject* parent)
    : QObject(parent), document_(document), plot_(plot), progress_(progress) {
  connect(&viewport, &Viewport::cursorMoved, this, &SpectrumController::pointAt);
  connect(&viewport, &Viewport::cursorLeft, this, &SpectrumController::leave);
  connect(&document, &Document::opened, this, &SpectrumController::forget);
  connect(&document, &Document::mapsChanged, this, &SpectrumController::refresh);
  connect(&document, &Document::sceneReplaced, this, &SpectrumController::refresh);
  connect(&document, &Document::editsChanged, this, &SpectrumController::refresh);
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
  plot_.clear();
  leave();
}

void SpectrumController::setSeen(bool seen) {
  if (seen == seen_) return;
  seen_ = seen;
  if (seen && pixel_) plotSpectra(pixel_->x(), pixel_->y());
}

void SpectrumController::refresh() {
  if (!pixel_) return;
  if (isPointedAt_) showReadout(*pixel_);
  if (seen_) plotSpectra(pixel_->x(), pixel_->y());
}

void SpectrumController::showReadout(const QPoint& pixel) {
  const QString text = pixelReadout(document_, pixel);
  const QFontMetrics font(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  const int room = static_cast<int>(kLargestShare * progress_.width());
  progress_.setReadout(font.elidedText(text, Qt::ElideRight, room));
}

void SpectrumController::plotSpectra(int x, int y) {
  const auto spectra = document_.spectraAt(x, y);
  if (!spectra) return plot_.clear();
  const bool edited = (spectra->originalParameters != spectra->editedParameters).any();
  plot_.setCurves(toVector(spectra->original),
                  edited ? toVector(spectra->edited) : QVector<double>(),
                  spectra->deviation ? toVector(*spectra->deviation) : QVector<double>());
  plot_.setHeading(tr("Pixel %1, %2").arg(x).arg(y));
}

}  // namespace cutis
