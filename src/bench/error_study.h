#pragma once

// The error protocol (resources/manual/fitting.md), run: all methods at all noises, and the bound
// that none of them can beat. Fills the figures; deterministic but for times. Cancelled if asked to
// stop.

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/bench/figures.h"
#include "src/bench/method_solvers.h"
#include "src/bench/subject.h"

namespace cutis {

// figures.bounds.
Status runBounds(const BenchSubject& subject, const JobContext& context, BenchFigures& figures);
// figures.methods and speedRatio. Relates to the bounds that are there.
Status runMethods(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                  BenchFigures& figures);
// figures.sample: skin of the sample instead of the population, at kUsualNoise.
Status runSample(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                 BenchFigures& figures);

}  // namespace cutis
