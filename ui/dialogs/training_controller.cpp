#include "ui/dialogs/training_controller.h"

#include <utility>

#include <QDir>

#include "src/app/training/network_errors.h"
#include "src/app/training/network_training.h"
#include "ui/dialogs/file_to_write.h"
#include "ui/dialogs/training_dialog.h"

namespace cutis {
namespace {

// Where training ends and measuring begins.
constexpr double kTrained = 0.97;

}  // namespace

TrainingController::TrainingController(Document& document, Engine& engine, JobRunner& jobs,
                                       QWidget* window)
    : QObject(window),
      document_(document),
      engine_(engine),
      jobs_(jobs),
      dialog_(new TrainingDialog(window)),
      plan_(usualTraining) {
  connect(&jobs, &JobRunner::progressed, this,
          [this](JobId id, const QString& stage, double fraction, double secondsLeft) {
            if (id == job_) dialog_->showProgress(stage, fraction, secondsLeft);
          });
  // Cancelled in the window itself: a training that has ended is no longer under way here.
  connect(&jobs, &JobRunner::finished, this, [this](JobId id) {
    if (id == job_) stop();
  });
  connect(&document, &Document::opened, this, &TrainingController::stop);
  connect(dialog_, &TrainingDialog::cancelWanted, this, &TrainingController::stop);
  connect(dialog_, &TrainingDialog::useWanted, this, &TrainingController::use);
  connect(dialog_, &TrainingDialog::saveWanted, this, &TrainingController::chooseFile);
}

void TrainingController::train() {
  if (!document_.canFit()) return;
  if (!jobs_.isRunning(job_)) {
    start(document_.scene().source->measurements.rig, document_.fitChoice().profile);
  }
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

void TrainingController::start(const Rig& rig, const std::string& profile) {
  const NetworkTraining training = plan_(rig, profile);
  profile_ = profile;
  trained_ = nullptr;
  dialog_->begin(QString::fromStdString(rig.name), QString::fromStdString(profile), training);
  job_ = jobs_.start(tr("Train a network"),
                     [this, rig, profile, training](const JobRunner::Handle& job) {
                       run(rig, profile, training, job);
                     });
}

void TrainingController::run(const Rig& rig, const std::string& profile,
                             const NetworkTraining& training, const JobRunner::Handle& job) {
  struct Outcome {
    TrainedNetworks trained;
    NetworkErrors errors;
  };
  const auto outcome = [&]() -> Result<Outcome> {
    CUTIS_TRY(model, engine_.model(profile, {}));
    NetworkTrainingState state;
    CUTIS_TRY(trained, trainNetworks(*model, rig, training, state, job.context.child(0.0, kTrained),
                                     [this, &job](const NetworkEpoch& epoch) {
                                       job.post([this, epoch] { dialog_->addEpoch(epoch); });
                                     }));
    CUTIS_TRY(errors, measureNetworks(*model, rig, trained.file,
                                      job.context.child(kTrained, 1.0, "errors")));
    return Outcome{std::move(trained), errors};
  }();
  if (outcome.failed()) {
    job.post([this, sentence = QString::fromStdString(outcome.error().text())] {
      job_ = 0;
      dialog_->showFailure(sentence);
    });
  } else if (outcome) {
    const auto file = std::make_shared<const NetworkFile>(outcome.value().trained.file);
    job.post(
        [this, file, errors = outcome.value().errors, seconds = outcome.value().trained.seconds] {
          job_ = 0;
          trained_ = file;
          dialog_->showResult(errors, seconds);
        });
  }
}

void TrainingController::stop() {
  jobs_.cancel(std::exchange(job_, 0));
  if (dialog_->isVisible()) dialog_->close();
}

void TrainingController::use() {
  document_.useNetwork(std::make_shared<const ChromophoreNetwork>(trained_->chromophores),
                       profile_);
  dialog_->close();
}

void TrainingController::save(const QString& path) {
  jobs_.startQuiet([this, path, file = trained_](const JobRunner::Handle& job) {
    const Status status = writeNetworks(path.toStdString(), *file);
    const bool failed = status.failed();
    const QString sentence = failed ? QString::fromStdString(status.error().text())
                                    : tr("Written: %1").arg(QDir::toNativeSeparators(path));
    job.post([this, sentence, failed] { dialog_->showSaved(sentence, failed); });
  });
}

void TrainingController::chooseFile() {
  const QString path = chooseFileToWrite(
      dialog_, tr("Save weights"), besideSource(document_, "weights.json"), tr("Weights (*.json)"));
  if (!path.isEmpty()) save(path);
}

}  // namespace cutis
