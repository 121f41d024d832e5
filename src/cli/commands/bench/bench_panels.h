#pragma once

#include "src/bench/figures.h"
#include "src/report/drawing.h"

namespace cutis {

// Time and memory of the refined fit against pixels and against threads, side by side in `area`.
// Says so where there is nothing to show.
void drawPicturePanels(Drawing& drawing, const Box& area, const BenchFigures& figures);

}  // namespace cutis
