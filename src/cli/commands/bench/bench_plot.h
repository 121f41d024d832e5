#pragma once  // internal to src/cli/commands/bench

#include "src/bench/figures.h"
#include "src/report/drawing.h"

namespace cutis {

// Run time of a picture of 2048² pixels against error, both logarithmic: our methods, what the
// paper published, and the bound. Refined fits that know the noise of 0.5 %, all else without
// noise. Below, time and memory of the refined fit against pixels and threads.
Drawing benchPlot(const BenchFigures& figures);

}  // namespace cutis
