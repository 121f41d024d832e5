#include "ui/dialogs/open_controller.h"

#include <algorithm>

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include "src/app/document/document.h"
#include "src/app/job_runner.h"
#include "src/app/open/image_inspection.h"
#include "src/app/open/image_search.h"
#include "src/app/project/manifest.h"
#include "ui/dialogs/capture_controller.h"
#include "ui/dialogs/format_filters.h"
#include "ui/dialogs/last_folder.h"
#include "ui/dialogs/open_as_dialog.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

constexpr int kMostRecentFiles = 8;
constexpr char kRecentFiles[] = "recentFiles";
constexpr char kOpenFolder[] = "open";

// Masks of others among them, which are offered when those are opened.
void leaveOutMasks(std::vector<std::filesystem::path>& files) {
  const std::vector<std::filesystem::path> all = files;
  std::erase_if(files, [&](const std::filesystem::path& file) {
    return isNamedMask(file) && std::any_of(all.begin(), all.end(), [&](const auto& other) {
             return !isNamedMask(other) && maskBeside(other) == file;
           });
  });
}

}  // namespace

OpenController::OpenController(JobRunner& jobs, ProgressStrip& progress, QWidget* window)
    : QObject(window),
      jobs_(jobs),
      progress_(progress),
      window_(window),
      captures_(new CaptureController(jobs, progress, window)) {
  connect(captures_, &CaptureController::openWanted, this, &OpenController::openWanted);
}

void OpenController::openSample() {
  progress_.clearMessages();
  Q_EMIT openWanted({});
}

void OpenController::open(const QString& path) {
  openAll({path});
}

void OpenController::openAll(const QStringList& paths) {
  progress_.clearMessages();
  if (paths.isEmpty()) {
    progress_.showMessage(
        tr("Only files and folders of this computer can be opened; save it here first"), true);
  }
  CaptureController::Files files;
  for (const QString& path : paths)
    files.emplace_back(QFileInfo(path).absoluteFilePath().toStdString());
  if (files.size() == 1 && !QFileInfo(paths.front()).isDir()) {
    Q_EMIT openWanted(files.front());
    return;
  }
  // Whether they may be a capture stands in their headers, and disks are slow.
  jobs_.start(tr("Look at %1 files").arg(files.size()),
              [this, files](const JobRunner::Handle& job) mutable {
                leaveOutMasks(files);
                const auto photographs = CaptureController::photographsOf(files);
                job.post([this, files, photographs] { openOrAsk(files, photographs); });
              });
}

void OpenController::openOrAsk(const std::vector<std::filesystem::path>& files,
                               const std::vector<std::filesystem::path>& photographs) {
  // A folder is opened as a whole.
  if (photographs.size() > 1) return captures_->look(photographs, files.size() == 1);
  for (const std::filesystem::path& file : files)
    Q_EMIT openWanted(file);
}

void OpenController::choosePhotographs() {
  captures_->choose();
}

QString OpenController::chooseFile(const QString& title, const QString& filter) {
  const QString file = QFileDialog::getOpenFileName(window_, title, lastFolder(kOpenFolder),
                                                    filter + ";;" + tr("All files (*)"));
  if (!file.isEmpty()) rememberFolderOf(kOpenFolder, file);
  return file;
}

void OpenController::chooseCapture() {
  const QString file = chooseFile(tr("Open capture"), tr("Captures (capture.json)"));
  if (!file.isEmpty()) open(file);
}

void OpenController::chooseImage() {
  const QString file = chooseFile(
      tr("Open image, maps or project"),
      tr("Images, maps and projects (%1 *%2)").arg(readableImagePatterns(), kProjectExtension));
  if (!file.isEmpty()) open(file);
}

void OpenController::chooseImageAs() {
  const QString file =
      chooseFile(tr("Open image as"), tr("Images (%1)").arg(readableImagePatterns()));
  if (!file.isEmpty()) openAs(file);
}

void OpenController::openAs(const QString& path, const QString& reason) {
  jobs_.start(tr("Look at %1").arg(QFileInfo(path).fileName()), [this, path, reason](
                                                                    const JobRunner::Handle& job) {
    const auto image = inspectImage(path.toStdString(), job.context);
    if (image && (reason.isEmpty() || !image.value().opensByItself())) {
      job.post([this, path, reason, inspected = image.value()] { ask(path, inspected, reason); });
    } else if (image.failed() && reason.isEmpty()) {
      job.post([this, sentence = QString::fromStdString(image.error().text())] {
        progress_.showMessage(sentence, true);
      });
    }
  });
}

void OpenController::ask(const QString& path, const ImageInspection& image, const QString& reason) {
  auto* dialog = new OpenAsDialog(path.toStdString(), image, reason, window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    progress_.clearMessages();
    Q_EMIT openAsWanted(dialog->path(), dialog->choice());
  });
  dialog->open();
}

QString OpenController::fileOf(const Document& document) {
  std::filesystem::path opened = document.projectPath();
  if (opened.empty() && !document.sourceFiles().empty()) opened = document.sourceFiles().front();
  if (opened.empty()) return {};
  return QFileInfo(QString::fromStdString(opened.string())).absoluteFilePath();
}

void OpenController::remember(const Document& document) {
  const QString file = fileOf(document);
  if (file.isEmpty()) return;
  QSettings settings;
  QStringList files = settings.value(kRecentFiles).toStringList();
  files.removeAll(file);
  files.prepend(file);
  settings.setValue(kRecentFiles, files.mid(0, kMostRecentFiles));
}

QStringList OpenController::recentFiles() const {
  QStringList existing;
  for (const QString& file : QSettings().value(kRecentFiles).toStringList()) {
    if (QFileInfo::exists(file)) existing << file;
  }
  return existing;
}

void forgetRecentFiles() {
  QSettings().remove(kRecentFiles);
}

}  // namespace cutis
