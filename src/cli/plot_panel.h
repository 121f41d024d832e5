#pragma once

// A framed field of a plot with its two scales.

#include <string>
#include <vector>

#include "src/report/drawing.h"
#include "src/report/scale.h"

namespace cutis {

struct PlotPanel {
  Box box;
  Scale x, y;  // their ends are the sides of the box

  Point at(double across, double upwards) const { return {x.at(across), y.at(upwards)}; }
};

// Places of a box for values from one end to the other.
PlotPanel plotPanel(const Box& box, double fromX, double toX, double fromY, double toY);
// Upwards whole decades that hold both values, which are positive.
PlotPanel decadePanel(const Box& box, double fromX, double toX, double least, double most);

// Lines and numbers of the decades left of the panel.
void drawDecades(Drawing& drawing, const PlotPanel& panel);
// Lines and numbers at round values: below the panel, and left of it.
void drawAcross(Drawing& drawing, const PlotPanel& panel, const std::vector<double>& ticks);
void drawUpwards(Drawing& drawing, const PlotPanel& panel, const std::vector<double>& ticks);
// The frame, a title above it and the name of the axis across.
void drawFrame(Drawing& drawing, const PlotPanel& panel, const std::string& title,
               const std::string& across);

// Values of `values` over those of `across`, of which there are as many.
void drawCurve(Drawing& drawing, const PlotPanel& panel, const std::vector<double>& across,
               const std::vector<double>& values, const Stroke& stroke);

// A piece of line and what it stands for.
void drawKey(Drawing& drawing, Point at, const Stroke& stroke, const std::string& words);

}  // namespace cutis
