#pragma once

// Places for a panel: how much room is needed around the area of its curves, and where values lie
// in it.

#include "src/report/plot/panel.h"
#include "src/report/plot/scale.h"
#include "src/report/plot/theme.h"
#include "src/report/text_metrics.h"

namespace cutis {

// Pixels around the area, for numbers, names and titles.
struct Rooms {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

struct PanelLayout {
  Box area;  // of the curves
  double titleTop = 0.0;
  double left = 0.0, right = 0.0;  // how far numbers below may reach
  Scale x, y;

  Point at(double across, double upwards) const { return {x.at(across), y.at(upwards)}; }

  bool operator==(const PanelLayout&) const = default;
};

// The sides do not depend on how wide the area is.
Rooms sideRooms(const Panel& panel, const PlotTheme& theme, const TextMetrics& metrics);
// All of them, for an area of that width.
Rooms roomsAround(const Panel& panel, double areaWidth, const PlotTheme& theme,
                  const TextMetrics& metrics);

// With an area given, as panels that stand in line share it. sides: the room that is kept there;
// titleTop: where the title begins.
PanelLayout layOut(const Panel& panel, const Box& area, const Rooms& sides, double titleTop,
                   const PlotTheme& theme);
// The panel with all its words within a box. The area is never negative.
PanelLayout layOut(const Panel& panel, const Box& outside, const PlotTheme& theme,
                   const TextMetrics& metrics);

}  // namespace cutis
