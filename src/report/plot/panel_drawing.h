#pragma once

// A panel and its layout as lines, areas and words: the frame, which changes seldom
// (panel_frame.cpp), and what is within it (panel_contents.cpp).

#include "src/report/plot/panel_layout.h"

namespace cutis {

// Shades, grid, axes and their numbers.
void drawFrame(Drawing& drawing, const Panel& panel, const PanelLayout& layout,
               const PlotTheme& theme, const TextMetrics& metrics);
// Curves, points, labels, the cursor, title and legend.
void drawContents(Drawing& drawing, const Panel& panel, const PanelLayout& layout,
                  const PlotTheme& theme, const TextMetrics& metrics);

}  // namespace cutis
