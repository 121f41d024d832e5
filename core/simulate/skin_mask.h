#pragma once

// Where photographs show skin.

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"
#include "core/rig/measurements.h"

namespace cutis {

// 1 for pixels that are there to be solved, 0 for all others; half, of the photographs' size.
// Errors: memory, disk. Cancelled if asked to stop.
Result<Plane> skinMask(const Measurements& photographs, const JobContext& context);

}  // namespace cutis
