#include "src/app/latest_job.h"

#include <utility>

namespace cutis {

void LatestJob::request(Work work) {
  if (isRunning()) {
    next_ = std::move(work);
  } else {
    start(std::move(work));
  }
}

void LatestJob::cancel() {
  next_.reset();
  jobs_.cancel(std::exchange(running_, 0));
}

void LatestJob::start(Work work) {
  running_ = jobs_.startQuiet([this, work = std::move(work)](const JobRunner::Handle& job) {
    job.post([this, show = work(job.context)] {
      running_ = 0;
      if (show) show();
      if (next_ && running_ == 0) start(*std::exchange(next_, {}));
    });
  });
}

}  // namespace cutis
