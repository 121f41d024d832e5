#pragma once

// Loops over independent pieces of work, on all cores.
//
// The outcome does not depend on the number of threads: pieces are numbered, each writes only what
// is its own, and of several failures the one with the lowest number is reported.

#include <cstddef>
#include <functional>

#include "core/base/job_context.h"
#include "core/base/result.h"

namespace cutis {

// Calls work(i) for each i in [0, count), in no particular order, several at once. Reports progress
// after each piece, one report at a time and never running backwards, and stops early when asked to
// (then Cancelled) or when a piece fails. An allocation that fails inside a piece becomes an Error
// of kind resource.
Status parallelFor(std::size_t count, const JobContext& context,
                   const std::function<Status(std::size_t)>& work);

// Cores the loops above may use now; a tbb::global_control lowers it.
int parallelThreadCount();

}  // namespace cutis
