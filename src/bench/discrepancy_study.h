#pragma once

// People who are not quite like the model, as the profile's discrepancy says, in front of the rig:
// how near the fit that estimates it comes to the bound that includes it. Deterministic. Cancelled
// if asked to stop.

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/bench/figures.h"
#include "src/bench/subject.h"

namespace cutis {

// figures.discrepancy; nothing for a profile without one.
Status runDiscrepancy(const BenchSubject& subject, const JobContext& context,
                      BenchFigures& figures);

}  // namespace cutis
