#include "ui/dialogs/export_controller.h"

#include <QFileInfo>

#include "src/app/document/document.h"
#include "src/app/export/export.h"
#include "ui/dialogs/file_to_write.h"
#include "ui/dialogs/format_filters.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

constexpr std::size_t kMemoryForExport = std::size_t{1} << 30;

}  // namespace

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
  const Scene& scene = document_.scene();
  ExportTarget target = {std::filesystem::path(path.toStdString())};
  for (const std::filesystem::path& file : document_.sourceFiles())
    target.sources.push_back(file.string());
  const QString name = tr("Export %1").arg(QFileInfo(path).fileName());
  jobs_.start(name, [this, path, name, target,
                     albedo = EditedAlbedo{scene, scene.source}](const JobRunner::Handle& job) {
    const auto store = std::make_shared<TileStore>(kMemoryForExport);
    const ExportOutcome outcome = exportWithNotes(target, albedo, engine_, store, job.context);
    if (outcome.status.cancelled()) return;
    const bool failed = outcome.status.failed();
    QString sentence = failed ? QString::fromStdString(outcome.status.error().text())
                              : tr("Written: %1").arg(path);
    for (const std::string& note : outcome.notes)
      sentence += "; " + QString::fromStdString(note);
    const bool isWorthKeeping = failed || !outcome.notes.empty();
    job.post([this, sentence, failed, name, isWorthKeeping] {
      progress_.showMessage(sentence, failed, name);
      if (isWorthKeeping) Q_EMIT noticed(sentence, failed);
    });
  });
}

void ExportController::choose() {
  const QString file =
      chooseFileToWrite(window_, tr("Export edited albedo"),
                        besideSource(document_, "edited_albedo.exr"), writableImageFilters());
  if (!file.isEmpty()) exportAlbedo(file);
}

}  // namespace cutis
