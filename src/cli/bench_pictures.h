#pragma once

// Whole pictures: time and memory of a fit against pixels and threads.

#include "src/cli/bench_errors.h"

namespace cutis {

struct PictureSeries {
  std::vector<int> sizes;    // pixels a side, increasing
  int largestSearch = 1024;  // searches are run up to this size and scaled beyond
  int scalingSize = 1024;    // of the pictures solved with 1, 2, … threads
};

// sizes and scaling; needs methods. Pixels that have nothing to do with their neighbours, of the
// protocol's population, and the sample; noise kUsualNoise. The time is that of the fit stage of
// `cutis-cli fit`, the fastest of three runs for the refined fits.
Status runPictures(const BenchSubject& subject, const PictureSeries& series, Session& session,
                   BenchSolvers& solvers, const JobContext& context, BenchFigures& figures);

// Threads the loops may use now.
int allowedThreads();

}  // namespace cutis
