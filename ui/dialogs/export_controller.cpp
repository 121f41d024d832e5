#include "ui/dialogs/export_controller.h"

#include <algorithm>

#include <QFileInfo>

#include "src/app/document/document.h"
#include "ui/dialogs/file_to_write.h"
#include "ui/dialogs/format_filters.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

constexpr std::size_t kMemoryForExport = std::size_t{1} << 30;

// Notes name the file; a sentence that has named it goes on without.
QString withoutPlace(const QString& note, const QString& path) {
  const QString place = path + ": ";
  return note.startsWith(place) ? note.mid(place.size()) : note;
}

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

QString ExportController::mapsObjection() const {
  if (!document_.isOpen()) return tr("Nothing is open yet");
  if (document_.scene().source == nullptr) return tr("These maps are a file already");
  return document_.isFitted() ? QString() : tr("The skin has not been fitted yet");
}

void ExportController::exportAlbedo(const QString& path) {
  const Scene& scene = document_.scene();
  write(path, [albedo = EditedAlbedo{scene, scene.source}]() -> Result<Exported> {
    return Exported(albedo);
  });
}

void ExportController::exportMaps(const QString& path) {
  write(path, [maps = document_.mapsFile()]() -> Result<Exported> {
    CUTIS_TRY(file, maps());
    return Exported(file);
  });
}

void ExportController::write(const QString& path, const std::function<Result<Exported>()>& what) {
  ExportTarget target = {std::filesystem::path(path.toStdString())};
  for (const std::filesystem::path& file : document_.sourceFiles())
    target.sources.push_back(file.string());
  const QString name = tr("Export %1").arg(QFileInfo(path).fileName());
  const auto work = [this, path, name, target, what](const JobRunner::Handle& job) {
    const auto outcome = [&]() -> ExportOutcome {
      const auto made = what();
      if (!made) return {made.failed() ? Status(made.error()) : Status(Cancelled{}), {}};
      const auto store = std::make_shared<TileStore>(kMemoryForExport);
      return exportWithNotes(target, made.value(), engine_, store, job.context);
    }();
    if (outcome.status.cancelled()) return;
    const bool failed = outcome.status.failed();
    QString sentence = failed ? QString::fromStdString(outcome.status.error().text())
                              : tr("Written: %1").arg(path);
    for (const std::string& note : outcome.notes)
      sentence += "; " + withoutPlace(QString::fromStdString(note), path);
    const bool isWorthKeeping = failed || !outcome.notes.empty();
    job.post([this, sentence, failed, name, isWorthKeeping] {
      if (!failed) ++writtenCount_;
      progress_.showMessage(sentence, failed, name);
      if (isWorthKeeping) Q_EMIT noticed(sentence, failed);
    });
  };
  exports_.push_back(jobs_.start(name, work));
}

bool ExportController::isExporting() const {
  return std::any_of(exports_.begin(), exports_.end(),
                     [this](JobId job) { return jobs_.isRunning(job); });
}

std::size_t ExportController::lostCount() const {
  const auto running = std::count_if(exports_.begin(), exports_.end(),
                                     [this](JobId job) { return jobs_.isRunning(job); });
  return exports_.size() - static_cast<std::size_t>(running) - writtenCount_;
}

void ExportController::stop() {
  for (const JobId job : exports_)
    jobs_.cancel(job);
}

void ExportController::choose() {
  const QString file =
      choosePlace(tr("Export edited albedo"), "edited_albedo.exr", writableImageFilters());
  if (!file.isEmpty()) exportAlbedo(file);
}

void ExportController::chooseMaps() {
  const QString file = choosePlace(tr("Save maps"), "maps.exr", tr("OpenEXR (*.exr)"));
  if (!file.isEmpty()) exportMaps(file);
}

QString ExportController::choosePlace(const QString& title, const QString& what,
                                      const QString& filters) {
  return chooseFileToWrite(
      window_, title, besideSourceNamedAfter(document_, what), filters,
      [this](const QString& path) { return objectionToWriting(document_, path); });
}

}  // namespace cutis
