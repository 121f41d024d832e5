#pragma once

// Where the refined fit begins, and what that costs: its own polynomial, ChromNN's answer, the mean
// of the prior.

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/bench/figures.h"
#include "src/bench/method_solvers.h"
#include "src/bench/subject.h"

namespace cutis {

// figures.starts; deterministic but for times. Cancelled if asked to stop.
Status runStarts(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                 BenchFigures& figures);

}  // namespace cutis
