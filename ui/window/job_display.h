#pragma once  // internal to ui/window

// Shows the running jobs in the progress strip: the newest, and when that ends the one before it.
// Interface thread only.

#include <map>
#include <optional>

#include <QObject>
#include <QString>

#include "src/app/job_runner.h"

namespace cutis {

class ProgressStrip;

class JobDisplay : public QObject {
  Q_OBJECT

 public:
  // Both outlive the display. The strip's cancel button cancels the job that is shown.
  JobDisplay(JobRunner& jobs, ProgressStrip& progress, QObject* parent = nullptr);

 private:
  void show(JobId id, const QString& stage, std::optional<double> fraction, double secondsLeft);
  void retire(JobId id);
  void cancelShown();

  JobRunner& jobs_;
  ProgressStrip& progress_;
  std::map<JobId, QString> names_;  // of the jobs that run
};

}  // namespace cutis
