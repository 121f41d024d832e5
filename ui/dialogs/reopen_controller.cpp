#include "ui/dialogs/reopen_controller.h"

#include <QFileDialog>
#include <QFileInfo>

#include "src/app/document/document.h"
#include "src/app/job_runner.h"
#include "src/app/open/image_inspection.h"
#include "src/app/open/image_search.h"
#include "ui/dialogs/file_field.h"
#include "ui/dialogs/open_as_dialog.h"
#include "ui/dialogs/question.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

QString nameOf(const std::filesystem::path& path) {
  return QString::fromStdString(path.filename().string());
}

}  // namespace

ReopenController::ReopenController(Document& document, JobRunner& jobs, ProgressStrip& progress,
                                   NoticeBar& notice, QWidget* window)
    : QObject(window),
      document_(document),
      jobs_(jobs),
      progress_(progress),
      notice_(notice),
      window_(window) {
  connect(&document, &Document::opened, this, &ReopenController::offerMaskBeside);
}

QString ReopenController::maskObjection() const {
  if (!document_.isOpen()) return tr("Nothing is open yet");
  return document_.canReopen()
             ? QString()
             : tr("The sample and maps take no mask; open a picture or a capture");
}

QString ReopenController::removeObjection() const {
  const QString objection = maskObjection();
  if (!objection.isEmpty()) return objection;
  return document_.openChoice().source.mask.empty() ? tr("No mask was chosen") : QString();
}

QString ReopenController::interpretObjection() const {
  if (!document_.isOpen()) return tr("Nothing is open yet");
  const bool isImage = document_.canReopen() && document_.sourceKind() == SourceKind::image;
  return isImage ? QString() : tr("Only a picture can be read in several ways");
}

void ReopenController::chooseMask() {
  const QFileInfo source(QString::fromStdString(document_.sourceFiles().front().string()));
  const FileFieldTexts texts = maskTexts();
  const QString file = QFileDialog::getOpenFileName(
      window_, texts.dialogTitle, source.isDir() ? source.filePath() : source.path(), texts.filter);
  if (!file.isEmpty()) useMask(file.toStdString());
}

void ReopenController::useMask(const std::filesystem::path& mask) {
  OpenChoice choice = document_.openChoice();
  choice.source.mask = mask.empty() ? mask : std::filesystem::absolute(mask).lexically_normal();
  progress_.clearMessages();
  document_.reopen(choice);
}

void ReopenController::offerMaskBeside() {
  notice_.hide();
  const std::filesystem::path mask = document_.maskBeside();
  if (mask.empty()) return;
  notice_.ask(tr("%1 lies beside it: use it as the mask?").arg(nameOf(mask)), tr("Use as mask"),
              tr("No"), [this, mask] { useMask(mask); });
}

bool ReopenController::askWhetherMask(const std::filesystem::path& dropped) {
  const bool isAsked =
      maskObjection().isEmpty() && mayBeMask(dropped) && dropped != document_.sourceFiles().front();
  if (!isAsked) return false;
  askQuestion(
      *window_, tr("Is %1 the mask of %2?").arg(nameOf(dropped), document_.name()),
      tr("As its mask it leaves out what is black in it. %1 is fitted again and keeps its "
         "edits.")
          .arg(document_.name()),
      {{tr("Use as mask"), QMessageBox::AcceptRole, [this, dropped] { useMask(dropped); }},
       {tr("Open as a picture"), QMessageBox::ActionRole,
        [this, dropped] { Q_EMIT pictureWanted(QString::fromStdString(dropped.string())); }},
       {tr("Cancel"), QMessageBox::RejectRole}});
  return true;
}

void ReopenController::interpret() {
  const std::filesystem::path path = document_.sourceFiles().front();
  jobs_.start(tr("Look at %1").arg(nameOf(path)), [this, path](const JobRunner::Handle& job) {
    const auto image = inspectImage(path, job.context);
    if (image) {
      job.post([this, inspected = image.value()] { ask(inspected); });
    } else if (image.failed()) {
      job.post([this, sentence = QString::fromStdString(image.error().text())] {
        progress_.showMessage(sentence, true);
      });
    }
  });
}

void ReopenController::ask(const ImageInspection& image) {
  auto* dialog = new OpenAsDialog(document_.sourceFiles().front(), image, {}, window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->showInterpretation(document_.openChoice());
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    progress_.clearMessages();
    document_.reopen(dialog->choice());
  });
  dialog->open();
}

}  // namespace cutis
