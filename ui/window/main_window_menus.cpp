// Menus and file dialogs of the main window.

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QMenuBar>
#include <QMessageBox>

#include "src/images/codec/image_formats.h"
#include "ui/dialogs/training_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/docks/fit_controller.h"
#include "ui/view/view_catalogue.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

// "*.tif *.tiff"
QString patternsOf(const ImageFormat& format) {
  QStringList patterns;
  for (const std::string_view extension : format.extensions)
    patterns << "*" + QString::fromLatin1(extension.data(), qsizetype(extension.size()));
  return patterns.join(' ');
}

QString readPatterns() {
  QStringList patterns;
  for (const ImageFormat& format : imageFormats())
    patterns << patternsOf(format);
  return patterns.join(' ');
}

// "OpenEXR (*.exr);;TIFF (*.tif *.tiff);;…"
QString writtenFilters() {
  QStringList filters;
  for (const ImageFormat& format : imageFormats()) {
    const QString name = QString::fromLatin1(format.name.data(), qsizetype(format.name.size()));
    if (format.isWritten()) filters << QString("%1 (%2)").arg(name, patternsOf(format));
  }
  return filters.join(";;");
}

}  // namespace

void MainWindow::makeMenus() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  file->addAction(tr("Open &sample"), QKeySequence(tr("Ctrl+Shift+O")), this,
                  &MainWindow::openSample);
  file->addAction(tr("Open &capture…"), QKeySequence(tr("Ctrl+K")), this,
                  &MainWindow::chooseCapture);
  file->addAction(tr("Open &image or maps…"), QKeySequence::Open, this, &MainWindow::chooseImage);
  file->addSeparator();
  export_ = file->addAction(tr("&Export edited albedo…"), QKeySequence(tr("Ctrl+E")), this,
                            &MainWindow::chooseExport);
  file->addSeparator();
  file->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  undo_ = edit->addAction(tr("&Undo"), QKeySequence::Undo, this, [this] { document_->undo(); });
  redo_ = edit->addAction(tr("&Redo"), this, [this] { document_->redo(); });
  redo_->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
  edit->addSeparator();
  edit->addAction(tr("Reset &all edits"), QKeySequence(tr("Ctrl+R")), this,
                  [this] { edits_->reset(); });

  QMenu* view = menuBar()->addMenu(tr("&View"));
  view->addAction(tr("&Whole picture (F)"), this, [this] { viewport_->fitPicture(); });
  view->addAction(tr("&One to one (1)"), this, [this] { viewport_->zoomOneToOne(); });
  view->addSeparator();
  int number = 1;
  for (const LayerDescription& layer : layerCatalogue()) {
    QAction* action =
        view->addAction(layer.name, this, [this, kind = layer.kind] { layers_->show(kind); });
    if (number <= 9) action->setShortcut(QKeySequence(QString("Alt+%1").arg(number)));
    action->setToolTip(layer.toolTip);
    ++number;
  }

  QMenu* fit = menuBar()->addMenu(tr("Fi&t"));
  load_ = fit->addAction(tr("Load &profile…"), QKeySequence(tr("Ctrl+Shift+L")), this,
                         &MainWindow::chooseProfile);
  train_ = fit->addAction(tr("&Train a network…"), QKeySequence(tr("Ctrl+T")), training_,
                          &TrainingController::train);

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  help->addAction(tr("&About Cutis"), this, [this] {
    QMessageBox::about(
        this, tr("About Cutis"),
        tr("<b>Cutis %1</b><p>An editor for human skin. It implements and extends the model of "
           "Li, Guarnera, Lin, Ghosh 2024, <i>Practical Measurement and Neural Encoding of "
           "Hyperspectral Skin Reflectance</i>.</p><p>Licence: Apache-2.0. Nothing you open leaves "
           "this machine.</p>")
            .arg(QCoreApplication::applicationVersion()));
  });
}

void MainWindow::chooseCapture() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open capture"), {},
                                                    tr("Captures (capture.json);;All files (*)"));
  if (!file.isEmpty()) openPath(file);
}

void MainWindow::chooseImage() {
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Open image or maps"), {}, tr("Images (%1);;All files (*)").arg(readPatterns()));
  if (!file.isEmpty()) openPath(file);
}

void MainWindow::chooseProfile() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Load profile"), {},
                                                    tr("Profiles (*.json);;All files (*)"));
  if (!file.isEmpty()) fit_->fitWithProfile(file);
}

void MainWindow::chooseExport() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Export edited albedo"),
                                                    "edited_albedo.exr", writtenFilters());
  if (!file.isEmpty()) exportAlbedo(file);
}

}  // namespace cutis
