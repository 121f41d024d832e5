#pragma once

// Whole pictures: time and memory of a fit against pixels and threads.

#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/bench/figures.h"
#include "src/bench/method_solvers.h"
#include "src/bench/subject.h"

namespace cutis {

struct PictureSeries {
  std::vector<int> sizes;  // pixels a side, increasing
  // Searches and the exact setting are run up to this size and scaled beyond.
  int largestSlow = 1024;
  int scalingSize = 1024;  // of the pictures solved with 1, 2, … threads
};

// Pixels that have nothing to do with their neighbours, of the protocol's population, and the
// sample; noise kUsualNoise, and none for the exact setting. The time is that of the fit
// stage of a fit, the fastest of three runs for the network and the refined fits that know the
// noise; the memory is that of the first. Both need methods.

// sizes, and firstPicture at the largest size that is not beyond 2048.
Status runSizes(const BenchSubject& subject, const PictureSeries& series, MethodSolvers& solvers,
                const JobContext& context, BenchFigures& figures);
Status runScaling(const BenchSubject& subject, const PictureSeries& series, MethodSolvers& solvers,
                  const JobContext& context, BenchFigures& figures);

}  // namespace cutis
