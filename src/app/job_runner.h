#pragma once

// Work in the background.
//
// A job runs on a thread of its own and hands results to the interface thread with post(). It is
// told to stop and then left alone: the interface never waits for it. What an older job posts after
// it was cancelled is dropped. A job that throws ends with one sentence, and the program goes on.
//
// Lives on the interface thread; all signals arrive there.

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <thread>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include "core/base/job_context.h"

namespace cutis {

using JobId = std::uint64_t;

class JobRunner : public QObject {
  Q_OBJECT

 public:
  // What a job may do besides its work.
  struct Handle {
    JobContext context;
    // Runs `action` on the interface thread, unless the job is cancelled by then. Thread-safe.
    std::function<void(std::function<void()> action)> post;
  };

  explicit JobRunner(QObject* parent = nullptr);
  ~JobRunner() override;

  // name: shown while it runs, e.g. "Fit"; a quiet job shows nothing.
  JobId start(const QString& name, std::function<void(const Handle&)> work);
  JobId startQuiet(std::function<void(const Handle&)> work);
  // Returns at once; nothing of the job arrives after this. Unknown and finished jobs are ignored.
  void cancel(JobId id);

  // Stops all jobs and waits for them; nothing of them arrives after this. For the owner of what
  // jobs work on, before it goes.
  void stopAll();

  // Whether a job runs that is neither cancelled nor quiet / that is not cancelled.
  bool isBusy() const;
  bool isIdle() const;
  bool isRunning(JobId id) const;

 Q_SIGNALS:
  void started(cutis::JobId id, const QString& name);
  // At most 30 times a second. secondsLeft is negative while there is no estimate.
  void progressed(cutis::JobId id, const QString& stage, double fraction, double secondsLeft);
  // The job threw: one sentence for the user. Before finished(); of quiet jobs, too, but of none
  // that is cancelled.
  void failed(cutis::JobId id, const QString& sentence);
  // Done, failed or cancelled.
  void finished(cutis::JobId id);
  // Nothing runs any more.
  void idle();

 private:
  struct Job;

  JobId launch(const QString& name, bool quiet, std::function<void(const Handle&)> work);
  void reportProgress();
  // failure: what the job threw, in words; empty where it ended well.
  void retire(JobId id, const QString& failure);
  Job* find(JobId id) const;

  std::list<std::unique_ptr<Job>> jobs_;  // running, cancelled ones included
  JobId nextId_ = 1;
  QTimer progressTimer_;
};

}  // namespace cutis
