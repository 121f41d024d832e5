#pragma once

// What changes an error when all else is equal: lights, parameters, file formats; and whether the
// deviations can be believed. Fills the figures; deterministic. Cancelled if asked to stop.

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/bench/figures.h"
#include "src/bench/method_solvers.h"
#include "src/bench/subject.h"

namespace cutis {

// figures.coverage.
Status runCoverage(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                   BenchFigures& figures);
// figures.lights: white light alone against all lights, the paper's Fig. 12. Nothing for a rig
// without.
Status runLights(const BenchSubject& subject, const JobContext& context, BenchFigures& figures);
// figures.parameters: β-carotene held at 0 against all five parameters, the paper's Fig. 13.
Status runParameters(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                     BenchFigures& figures);
// figures.encodings.
Status runEncodings(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                    BenchFigures& figures);

}  // namespace cutis
