#pragma once

// Shows the running jobs in the progress strip: the newest, and when that ends the one before it.
// Interface thread only.

#include <functional>
#include <vector>

#include <QObject>
#include <QString>

#include "src/app/job_runner.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {

class JobDisplay : public QObject {
  Q_OBJECT

 public:
  // The strip outlives the display; its cancel button calls cancelShown().
  explicit JobDisplay(ProgressStrip& progress, QObject* parent = nullptr);

  // Shows the jobs of this runner, too, for as long as it lives.
  void watch(JobRunner& jobs);

  // Whether a job is shown.
  bool showsJob() const { return !running_.empty(); }
  // Cancels it, and says so.
  void cancelShown();

 private:
  struct RunningJob {
    JobRunner* runner;
    JobId id;
    QString name;
  };

  void begin(const RunningJob& job);
  void show(const RunningJob& job, const JobState& state);
  void retire(const std::function<bool(const RunningJob&)>& isOver);

  ProgressStrip& progress_;
  std::vector<RunningJob> running_;  // the newest last
};

}  // namespace cutis
