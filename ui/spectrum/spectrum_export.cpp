#include "ui/spectrum/spectrum_export.h"

#include <filesystem>
#include <mutex>
#include <string>
#include <utility>

#include <QClipboard>
#include <QCoreApplication>
#include <QFileInfo>
#include <QGuiApplication>

#include "src/app/document/document.h"
#include "src/app/document/methods_text.h"
#include "src/files/io/atomic_write.h"
#include "src/files/io/file_extension.h"
#include "src/report/picture_file.h"
#include "src/report/plot/page.h"
#include "ui/dialogs/file_to_write.h"
#include "ui/plot/drawing_pages.h"
#include "ui/plot/pin_colors.h"
#include "ui/plot/spectrum_plot.h"
#include "ui/spectrum/pin_controller.h"
#include "ui/spectrum/pin_text.h"
#include "ui/spectrum/spectrum_panel.h"
#include "ui/spectrum/spectrum_text.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

// Two columns of a paper, 180 mm, at 96 pixels per inch.
constexpr double kFigureWidth = 680;
constexpr double kFigureHeight = 300;
constexpr double kClipboardScale = 2;

std::string programVersion() {
  return QCoreApplication::applicationVersion().toStdString();
}

// PNG is drawn on one thread at a time.
Status writePage(const std::filesystem::path& path, const Drawing& drawing) {
  static std::mutex drawingPng;
  if (lowerExtension(path) != ".pdf") {
    const std::lock_guard lock(drawingPng);
    return writeDrawing(path, drawing);
  }
  const QByteArray bytes = pdfOf(drawing);
  return writeTextAtomically(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

// What bands and bars are.
std::string notesOnReflectance(const SpectrumFigure& figure) {
  std::string notes = SpectrumExport::tr("Bands: ± 2 posterior standard deviations.").toStdString();
  if (!figure.channels.isEmpty())
    notes += ' ' + SpectrumExport::tr(
                       "Photograph: a channel each, ± 2 standard deviations of its "
                       "noise and ± 1 of its response across; rings: what the "
                       "curve gives in it.")
                       .toStdString();
  return notes;
}

}  // namespace

SpectrumExport::SpectrumExport(Document& document, JobRunner& jobs, PinController& pins,
                               ProgressStrip& progress, QWidget* window)
    : document_(document), jobs_(jobs), pins_(pins), progress_(progress), window_(window) {
  connect(&pins, &PinController::readingsChanged, this, &SpectrumExport::objectionsChanged);
}

void SpectrumExport::attach(SpectrumPanel& panel) {
  panel_ = &panel;
  connect(&panel.plot(), &SpectrumPlot::emptinessChanged, this, &SpectrumExport::objectionsChanged);
}

QString SpectrumExport::objectionToCurves() const {
  if (panel_ == nullptr || !panel_->isVisible())
    return tr("Curves are computed while the Spectrum dock is shown; show it (F9)");
  return hasCurves(panel_->plot().figure()) ? QString()
                                            : tr("There is no curve; point at skin in the picture");
}

QString SpectrumExport::objectionToPins() const {
  return pins_.objectionToReadings();
}

QString SpectrumExport::objectionToMethods() const {
  return document_.isOpen() ? QString() : tr("Nothing is open yet");
}

Drawing SpectrumExport::figure() const {
  const SpectrumFigure& shown = panel_->plot().figure();
  Page page;
  page.width = kFigureWidth;
  page.heading = shown.title.toStdString();
  page.description = tr("Spectra of skin from 300 to 1000 nm").toStdString();
  SpectrumFigure untitled = shown;
  untitled.title.clear();
  PanelRow row;
  row.height = kFigureHeight;
  row.panels = {panelOf(untitled, {printTheme(), tickWords, printedPinColor, true, {}, {}})};
  page.rows = {row};
  if (shown.quantity == SpectrumQuantity::reflectance) page.notes = {notesOnReflectance(shown)};
  if (document_.isOpen())
    page.notes.push_back(captionText(document_.scene(), document_.fitChoice(), programVersion()));
  return layOut(page);
}

void SpectrumExport::copyText(const std::string& text, const QString& sentence) {
  QGuiApplication::clipboard()->setText(QString::fromStdString(text));
  progress_.showMessage(sentence, false);
}

void SpectrumExport::copyCurves() {
  copyText(curvesText(panel_->plot().figure(), '\t'),
           tr("The curves are on the clipboard, as a table."));
}

void SpectrumExport::copyPins() {
  copyText(pinsText(pins_.readings(), document_.pins(), '\t'),
           tr("The pins are on the clipboard, as a table."));
}

void SpectrumExport::copyMethods() {
  copyText(methodsText(document_.scene(), document_.fitChoice(), programVersion()),
           tr("A paragraph on methods is on the clipboard."));
}

void SpectrumExport::copyFigure() {
  QGuiApplication::clipboard()->setImage(imageOf(figure(), kClipboardScale));
  progress_.showMessage(tr("The figure is on the clipboard, as a picture."), false);
}

void SpectrumExport::saveFigure() {
  const QString path = choosePlace(tr("Save figure"), "spectra.pdf",
                                   tr("PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;Curves (*.csv)"));
  if (!path.isEmpty()) writeFigure(path);
}

void SpectrumExport::savePins() {
  const QString path = choosePlace(tr("Save table of pins"), "pins.csv", tr("CSV (*.csv)"));
  if (!path.isEmpty()) writePins(path);
}

QString SpectrumExport::choosePlace(const QString& title, const QString& what,
                                    const QString& filters) {
  return chooseFileToWrite(
      window_, title, besideSourceNamedAfter(document_, what), filters,
      [this](const QString& path) { return objectionToWriting(document_, path); });
}

void SpectrumExport::writeFigure(const QString& path) {
  const std::filesystem::path target = path.toStdString();
  if (lowerExtension(target) == ".csv") {
    return write(path, [target, text = curvesText(panel_->plot().figure(), ',')] {
      return writeTextAtomically(target, text);
    });
  }
  write(path, [target, drawing = figure()] { return writePage(target, drawing); });
}

void SpectrumExport::writePins(const QString& path) {
  write(path, [target = std::filesystem::path(path.toStdString()),
               text = pinsText(pins_.readings(), document_.pins(), ',')] {
    return writeTextAtomically(target, text);
  });
}

void SpectrumExport::write(const QString& path, std::function<Status()> work) {
  const QString objection = objectionToWriting(document_, path);
  if (!objection.isEmpty()) return progress_.showMessage(objection, true);
  const QString name = tr("Write %1").arg(QFileInfo(path).fileName());
  jobs_.start(name, [this, path, name, work = std::move(work)](const JobRunner::Handle& job) {
    const Status written = work();
    const QString sentence = written.failed() ? QString::fromStdString(written.error().text())
                                              : tr("Written: %1").arg(path);
    job.post([this, sentence, name, failed = written.failed()] {
      progress_.showMessage(sentence, failed, name);
    });
  });
}

}  // namespace cutis
