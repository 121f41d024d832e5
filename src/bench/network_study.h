#pragma once

// Networks in the benchmark: how far off they are at every noise, and what they cost.

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/bench/figures.h"
#include "src/bench/method_solvers.h"
#include "src/bench/subject.h"

namespace cutis {

// How much is run.
struct NetworkSeries {
  int size = 2048;        // pixels a side of the picture that is encoded and decoded
  bool training = false;  // train networks for the rig of the benchmark, about 15 s on two cores
};

// The networks that are built in for the subject's profile: of all channels of its rig, of the
// paper's five, of white light alone; where there are none of all channels, those that were
// trained. The solvers get the ones of all channels.
Status runNetworks(const BenchSubject& subject, const NetworkSeries& series, MethodSolvers& solvers,
                   const JobContext& context, BenchFigures& figures);

}  // namespace cutis
