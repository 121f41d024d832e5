#pragma once  // internal to src/cli/commands/bench

#include "src/bench/figures.h"
#include "src/report/plot/page.h"

namespace cutis {

// Time and memory of the refined fit against pixels and against threads, side by side. Says so
// where there is nothing to show.
PanelRow pictureRow(const BenchFigures& figures);

}  // namespace cutis
