#include "ui/dialogs/capture_controller.h"

#include <algorithm>

#include <QFileDialog>

#include "src/app/job_runner.h"
#include "src/app/open/capture_candidates.h"
#include "src/app/open/image_search.h"
#include "src/images/capture/capture_description.h"
#include "src/images/capture/capture_file.h"
#include "src/images/maps/maps_file.h"
#include "ui/dialogs/capture_assistant.h"
#include "ui/dialogs/format_filters.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {

CaptureController::CaptureController(JobRunner& jobs, ProgressStrip& progress, QWidget* window)
    : QObject(window), jobs_(jobs), progress_(progress), window_(window) {}

CaptureController::Files CaptureController::photographsOf(const Files& opened) {
  std::error_code ignored;
  if (opened.size() == 1 && std::filesystem::is_directory(opened.front(), ignored)) {
    return hasCaptureDescription(opened.front()) ? Files() : photographsIn(opened.front());
  }
  const bool areImages = std::none_of(opened.begin(), opened.end(), [](const auto& file) {
    return looksLikeCapture(file) || file.extension() == ".cutis" || isMapsFile(file);
  });
  return areImages && opened.size() > 1 && !areTilesOrFrames(opened) ? opened : Files();
}

void CaptureController::look(const Files& photographs, bool areOneCapture) {
  jobs_.start(tr("Look at %1 photographs").arg(photographs.size()),
              [this, photographs, areOneCapture](const JobRunner::Handle& job) {
                const auto looked = inspectPhotographs(photographs, job.context);
                if (looked && (areOneCapture || looked.value().areOfOneScene)) {
                  job.post([this, candidates = looked.value()] { ask(candidates); });
                } else if (looked.failed() && areOneCapture) {
                  job.post([this, sentence = QString::fromStdString(looked.error().text())] {
                    progress_.showMessage(sentence, true);
                  });
                } else if (!looked.cancelled()) {
                  // What is wrong with one of them is said when that is opened.
                  job.post([this, photographs] { openEach(photographs); });
                }
              });
}

void CaptureController::choose() {
  const QStringList names =
      QFileDialog::getOpenFileNames(window_, tr("Open the photographs of one capture"), {},
                                    tr("Images (%1);;All files (*)").arg(readableImagePatterns()));
  Files files;
  for (const QString& name : names)
    files.emplace_back(name.toStdString());
  if (!files.empty()) look(files, true);
}

void CaptureController::ask(const CaptureCandidates& candidates) {
  auto* assistant = new CaptureAssistant(candidates, window_);
  assistant->setAttribute(Qt::WA_DeleteOnClose);
  connect(assistant, &CaptureAssistant::eachWanted, this, &CaptureController::openEach);
  connect(assistant, &QDialog::accepted, this, [this, assistant] {
    const Status written = writeCaptureDescription(assistant->folder(), assistant->description());
    if (written.failed()) {
      progress_.showMessage(QString::fromStdString(written.error().text()), true);
    } else {
      Q_EMIT openWanted(assistant->folder());
    }
  });
  assistant->open();
}

void CaptureController::openEach(const Files& files) {
  for (const std::filesystem::path& file : files)
    Q_EMIT openWanted(file);
}

}  // namespace cutis
