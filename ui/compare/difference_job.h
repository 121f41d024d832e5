#pragma once  // internal to ui/compare

// Computes how two parts of the picture differ, in the background; only the newest pair counts.
// Interface thread only.

#include <functional>
#include <memory>

#include "src/app/job_runner.h"
#include "src/app/views/view_part.h"

namespace cutis {

class DifferenceJob {
 public:
  using Part = std::shared_ptr<const ViewPart>;
  using Show = std::function<void(const Part& difference)>;

  // The runner outlives the job.
  DifferenceJob(JobRunner& jobs, Show show);
  ~DifferenceJob();
  DifferenceJob(const DifferenceJob&) = delete;
  DifferenceJob& operator=(const DifferenceJob&) = delete;

  // Nothing happens where they are not of the same place. A part at half the resolution of the
  // other is compared at that. Of colours CIEDE2000, of values |second − first|, as a part of
  // `first`'s request with one channel.
  void start(const Part& first, const Part& second);
  void stop();

 private:
  JobRunner& jobs_;
  Show show_;
  JobId job_ = 0;
};

}  // namespace cutis
