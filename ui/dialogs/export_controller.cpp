#include "ui/dialogs/export_controller.h"

#include <QFileDialog>
#include <QFileInfo>

#include "src/app/document/document.h"
#include "src/app/export/albedo_export.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {

ExportController::ExportController(Document& document, Engine& engine, JobRunner& jobs,
                                   ProgressStrip& progress, QWidget* window)
    : QObject(window),
      document_(document),
      engine_(engine),
      jobs_(jobs),
      progress_(progress),
      window_(window) {}

QString ExportController::objection() const {
  if (!document_.isOpen()) return tr("Nothing is open yet");
  if (document_.scene().source == nullptr) {
    return tr("Maps alone hold no albedo; open the photographs they were fitted to");
  }
  return document_.isFitted() ? QString() : tr("The skin has not been fitted yet");
}

void ExportController::exportAlbedo(const QString& path) {
  const std::filesystem::path file(path.toStdString());
  jobs_.start(tr("Export %1").arg(QFileInfo(path).fileName()),
              [this, file, path, scene = document_.scene(),
               sources = document_.sourceFiles()](const JobRunner::Handle& job) {
                const auto store = std::make_shared<TileStore>(std::size_t{1} << 30);
                const Status status =
                    cutis::exportAlbedo(scene, engine_, file, sources, store, job.context);
                if (status.cancelled()) return;
                const bool failed = status.failed();
                const QString sentence = failed ? QString::fromStdString(status.error().text())
                                                : tr("Written: %1").arg(path);
                job.post([this, sentence, failed] { progress_.showMessage(sentence, failed); });
              });
}

void ExportController::choose() {
  const QString file = QFileDialog::getSaveFileName(
      window_, tr("Export edited albedo"), "edited_albedo.exr",
      tr("OpenEXR (*.exr);;TIFF (*.tif *.tiff);;PNG (*.png);;JPEG (*.jpg)"));
  if (!file.isEmpty()) exportAlbedo(file);
}

}  // namespace cutis
