#pragma once

// Work in the background of which only the newest matters: what a hand that moves asks for again
// and again. While one piece runs only the last that was asked for waits; what runs is not broken
// off, so that something is shown while the hand moves on. Interface thread only.

#include <functional>
#include <optional>

#include "src/app/job_runner.h"

namespace cutis {

class LatestJob {
 public:
  // Runs in the background; what it returns then runs on the interface thread.
  using Work = std::function<std::function<void()>(const JobContext& context)>;

  // The runner outlives it.
  explicit LatestJob(JobRunner& jobs) : jobs_(jobs) {}
  ~LatestJob() { cancel(); }
  LatestJob(const LatestJob&) = delete;
  LatestJob& operator=(const LatestJob&) = delete;

  void request(Work work);
  // Nothing arrives any more of what was requested.
  void cancel();
  // Whether something that was requested has not arrived yet.
  bool isRunning() const { return jobs_.isRunning(running_); }

 private:
  void start(Work work);

  JobRunner& jobs_;
  JobId running_ = 0;
  std::optional<Work> next_;
};

}  // namespace cutis
