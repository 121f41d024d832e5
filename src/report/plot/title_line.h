#pragma once  // internal to src/report/plot

// The line above a plot: a title on the left, a legend on the right, or below where there is no
// room for both.

#include <string>
#include <vector>

#include "src/report/plot/panel.h"
#include "src/report/plot/theme.h"
#include "src/report/text_metrics.h"

namespace cutis {

struct TitleLine {
  std::string title;
  TextStyle style;
  std::vector<LegendEntry> legend;
};

// The height of all lines that it takes between two sides so far apart; 0 if there is nothing to
// say.
double titleHeight(const TitleLine& line, double width, const PlotTheme& theme,
                   const TextMetrics& metrics);

// Adds it with its upper left corner at `at`. A title that has no room is shortened.
void drawTitle(Drawing& drawing, const TitleLine& line, Point at, double width,
               const PlotTheme& theme, const TextMetrics& metrics);

// Adds a marker, with a rim of ground that keeps apart those that lie on each other.
void drawMarker(Drawing& drawing, Point at, const Marker& marker, double rim, Color ground);

}  // namespace cutis
