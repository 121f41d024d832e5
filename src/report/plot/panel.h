#pragma once

// What a plot shows, without any place: axes, and what lies between them. layOut() of
// panel_layout.h finds the places.
//
// Values that have no place (NaN, and what is not positive on a logarithmic axis) leave gaps; what
// lies beyond the ends of an axis is cut off.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "src/report/drawing.h"
#include "src/report/plot/axis.h"

namespace cutis {

enum class Shape { disc, square };

struct Marker {
  Color color;
  double radius = 5.5;  // half of the side of a square
  bool isFilled = true;
  Shape shape = Shape::disc;
};

// A part of the axis across, shaded from bottom to top.
struct Shade {
  double from = 0.0, to = 0.0;
  Color color;
  std::string name;  // above the panel

  bool operator==(const Shade&) const = default;
};

// The area between two curves; x, low and high have as many values.
struct Ribbon {
  std::vector<double> x, low, high;
  Color color;
};

// A line all across at one value, with words at its right end.
struct Level {
  double value = 0.0;
  Stroke stroke;
  std::string words;
};

// x and y have as many values.
struct Curve {
  std::vector<double> x, y;
  Stroke stroke;
  std::optional<Marker> marker;  // at every value
};

// The ends of an error bar; none where they are NaN.
struct ErrorBar {
  double low = std::nan(""), high = std::nan("");
};

struct PlotPoint {
  double x = 0.0, y = 0.0;
  Marker marker;
  std::string label;  // put where it covers neither points nor other labels
  ErrorBar across, upwards;
  double barWidth = 1.0;
};

struct LegendEntry {
  std::string words;
  Stroke stroke = kNoStroke;
  std::optional<Marker> marker;
};

struct Panel {
  std::string title;
  bool isSmall = false;  // one of many: the title is written as small as the numbers
  std::vector<LegendEntry> legend;
  Axis x, y;
  std::vector<Tick> above;  // a second set of ticks across, on the upper side
  std::vector<Shade> shades;
  std::vector<Ribbon> ribbons;
  std::vector<Level> levels;
  std::vector<Curve> curves;
  std::vector<PlotPoint> points;
  // A line upwards with its number in a frame, which takes the place of those it would touch.
  std::optional<Tick> cursor;
  // Stands in the middle in place of the axis upwards and of what there is to see.
  std::string message;
};

}  // namespace cutis
