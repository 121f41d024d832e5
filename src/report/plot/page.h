#pragma once

// A report's picture: a heading, rows of panels, and notes, one below the other.

#include <string>
#include <vector>

#include "src/report/plot/panel.h"
#include "src/report/plot/theme.h"
#include "src/report/text_metrics.h"

namespace cutis {

// Areas of all panels are equally wide. The panels of rows with the same number of columns stand
// in line.
struct PanelRow {
  std::string title;                // above all of its panels …
  std::vector<LegendEntry> legend;  // … and what holds for all of them
  std::string note;                 // below the title
  double height = 200.0;            // of the area of curves alone, pixels
  std::vector<Panel> panels;
  std::size_t columns = 0;  // 0: as many as there are panels
};

struct Page {
  double width = 920.0;  // pixels; the height follows
  std::string heading;
  std::string description;                // for a reader who cannot see it
  std::vector<std::string> introduction;  // paragraphs
  std::vector<PanelRow> rows;
  std::vector<std::string> notes;  // paragraphs
};

Drawing layOut(const Page& page, const PlotTheme& theme = printTheme(),
               const TextMetrics& metrics = printMetrics());

}  // namespace cutis
