#include "ui/documents/job_display.h"

namespace cutis {

JobDisplay::JobDisplay(ProgressStrip& progress, QObject* parent)
    : QObject(parent), progress_(progress) {
  connect(&progress, &ProgressStrip::cancelWanted, this, &JobDisplay::cancelShown);
}

void JobDisplay::watch(JobRunner& jobs) {
  JobRunner* runner = &jobs;
  connect(runner, &JobRunner::started, this, [this, runner](JobId id, const QString& name) {
    begin({runner, id, name});
  });
  connect(runner, &JobRunner::progressed, this,
          [this, runner](JobId id, const QString& stage, double fraction, double secondsLeft) {
            show({runner, id, {}},
                 {{},
                  stage,
                  fraction,
                  secondsLeft < 0.0 ? std::nullopt : std::optional<double>(secondsLeft)});
          });
  connect(runner, &JobRunner::finished, this, [this, runner](JobId id) {
    retire([&](const RunningJob& job) { return job.runner == runner && job.id == id; });
  });
  connect(runner, &QObject::destroyed, this,
          [this, runner] { retire([&](const RunningJob& job) { return job.runner == runner; }); });
}

void JobDisplay::begin(const RunningJob& job) {
  running_.push_back(job);
  // That it was cancelled before is of no interest any more.
  progress_.withdraw(job.name);
  show(job, {});
}

void JobDisplay::show(const RunningJob& job, const JobState& state) {
  if (running_.empty()) return;
  const RunningJob& newest = running_.back();
  if (newest.runner != job.runner || newest.id != job.id) return;
  JobState named = state;
  named.name = newest.name;
  progress_.setJob(named);
}

void JobDisplay::retire(const std::function<bool(const RunningJob&)>& isOver) {
  std::erase_if(running_, isOver);
  if (running_.empty()) {
    progress_.clearJob();
  } else {
    show(running_.back(), {});
  }
}

void JobDisplay::cancelShown() {
  if (running_.empty()) return;
  const RunningJob shown = running_.back();
  shown.runner->cancel(shown.id);
  progress_.showMessage(tr("%1: cancelled").arg(shown.name), false, shown.name);
}

}  // namespace cutis
