#include "ui/window/job_display.h"

#include "ui/widgets/progress_strip.h"

namespace cutis {

JobDisplay::JobDisplay(JobRunner& jobs, ProgressStrip& progress, QObject* parent)
    : QObject(parent), jobs_(jobs), progress_(progress) {
  connect(&jobs, &JobRunner::started, this, [this](JobId id, const QString& name) {
    names_[id] = name;
    // That it was cancelled before is of no interest any more.
    progress_.withdraw(name);
    show(id, {}, std::nullopt, -1.0);
  });
  connect(&jobs, &JobRunner::progressed, this, &JobDisplay::show);
  connect(&jobs, &JobRunner::finished, this, &JobDisplay::retire);
  connect(&progress, &ProgressStrip::cancelWanted, this, &JobDisplay::cancelShown);
}

void JobDisplay::show(JobId id, const QString& stage, std::optional<double> fraction,
                      double secondsLeft) {
  if (names_.empty() || id != names_.rbegin()->first) return;
  progress_.setJob({names_.rbegin()->second, stage, fraction,
                    secondsLeft < 0.0 ? std::nullopt : std::optional<double>(secondsLeft)});
}

void JobDisplay::retire(JobId id) {
  names_.erase(id);
  if (names_.empty()) {
    progress_.clearJob();
  } else {
    show(names_.rbegin()->first, {}, std::nullopt, -1.0);
  }
}

void JobDisplay::cancelShown() {
  if (names_.empty()) return;
  const auto [id, name] = *names_.rbegin();
  jobs_.cancel(id);
  progress_.showMessage(tr("%1: cancelled").arg(name), false, name);
}

}  // namespace cutis
