#include "ui/dialogs/save_controller.h"

#include <utility>

#include <QFileInfo>

#include "src/app/document/document.h"
#include "src/app/project/manifest.h"
#include "ui/dialogs/file_to_write.h"
#include "ui/dialogs/last_folder.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

constexpr char kSaveFolder[] = "save";

}  // namespace

SaveController::SaveController(Document& document, ProgressStrip& progress,
                               std::function<ProjectView()> view, QWidget* window)
    : QObject(window),
      document_(document),
      progress_(progress),
      view_(std::move(view)),
      window_(window) {
  connect(&document, &Document::saved, this, [this](const QString& path) {
    progress_.showMessage(tr("Saved: %1").arg(path), false, tr("Save"));
    end(true);
  });
  connect(&document, &Document::notSaved, this, [this] {
    ++lostCount_;
    end(false);
  });
  // Said once more, so that what comes of the next attempt takes its place.
  connect(&document, &Document::failed, this, [this](const QString& sentence) {
    if (document_.isSaving()) progress_.showMessage(sentence, true, tr("Save"));
  });
}

QString SaveController::objection() const {
  return document_.isOpen() ? QString() : tr("Nothing is open yet");
}

void SaveController::save() {
  saveThen({});
}

void SaveController::saveAs() {
  const QString path = choosePlace();
  if (!path.isEmpty()) saveTo(path);
}

void SaveController::saveTo(const QString& path) {
  progress_.withdraw(tr("Save"));
  document_.setView(view_());
  document_.save(path.toStdString());
}

void SaveController::saveThen(std::function<void(bool saved)> then) {
  const auto& place = document_.projectPath();
  const QString path = place.empty() ? choosePlace() : QString::fromStdString(place.string());
  then_ = std::move(then);
  if (path.isEmpty()) return end(false);
  saveTo(path);
}

void SaveController::end(bool saved) {
  if (const auto then = std::exchange(then_, {})) then(saved);
}

QString SaveController::choosePlace() {
  const QString name = QFileInfo(document_.name()).completeBaseName() + kProjectExtension;
  QString suggested = besideSource(document_, name);
  if (suggested == name && !lastFolder(kSaveFolder).isEmpty())
    suggested = lastFolder(kSaveFolder) + "/" + name;
  const auto& place = document_.projectPath();
  if (!place.empty()) suggested = QString::fromStdString(place.string());
  const QString path = chooseFileToWrite(window_, tr("Save project"), suggested,
                                         tr("Projects (*%1)").arg(kProjectExtension));
  if (!path.isEmpty()) rememberFolderOf(kSaveFolder, path);
  return path;
}

}  // namespace cutis
