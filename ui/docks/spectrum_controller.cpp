#include "ui/docks/spectrum_controller.h"

#include <QVector>

#include "ui/plot/spectrum_plot.h"
#include "ui/view/viewport.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

QVector<double> toVector(const Spectrum& spectrum) {
  return QVector<double>(spectrum.data(), spectrum.data() + spectrum.size());
}

QString readoutOf(int x, int y, const ParameterVector& parameters) {
  QString text = QString("x %1  y %2").arg(x).arg(y);
  for (const Parameter parameter : kParameters) {
    const auto symbol = parameterSymbol(parameter);
    text += QString("   %1 %2")
                .arg(QString::fromUtf8(symbol.data(), static_cast<qsizetype>(symbol.size())))
                .arg(parameters[parameter], 0, 'g', 3);
  }
  return text;
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
  refresh();
}

void SpectrumController::leave() {
  progress_.setReadout({});
}

void SpectrumController::forget() {
  pixel_.reset();
  plot_.clear();
  progress_.setReadout({});
}

void SpectrumController::setSeen(bool seen) {
  if (seen == seen_) return;
  seen_ = seen;
  if (seen && pixel_) plotSpectra(pixel_->x(), pixel_->y());
}

void SpectrumController::refresh() {
  if (!pixel_) return;
  const int x = pixel_->x(), y = pixel_->y();
  const auto parameters = document_.editedParametersAt(x, y);
  progress_.setReadout(parameters ? readoutOf(x, y, *parameters)
                                  : tr("x %1  y %2   no skin here").arg(x).arg(y));
  if (seen_) plotSpectra(x, y);
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
