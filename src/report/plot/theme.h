#pragma once

// Colours and sizes of all plots: light for print, dark for the window (ui/plot/window_theme.h).

#include "src/report/drawing.h"

namespace cutis {

// These differ in hue and in lightness, for readers who do not distinguish all hues.
struct SeriesColors {
  Color orange, blue, purple, grey, green;
};

struct PlotTheme {
  Color ground;  // behind everything, and around markers
  Color ink;
  Color muted;       // numbers and notes
  Color grid;        // lines across a panel
  Color frame;       // around a panel, and of its axes
  Color shade;       // what a panel is about …
  Color outerShade;  // … and what lies beside it
  SeriesColors series;

  TextStyle heading;  // of a page
  TextStyle title;    // of a panel
  TextStyle label;
  TextStyle tick;
  TextStyle note;

  double space = 8.0;      // between words and what they belong to
  double farSpace = 16.0;  // between panels
  bool isFramed = true;    // a rectangle around each panel
  // The name of an axis stands beside it; else its last number has the unit, which takes less room.
  bool hasAxisTitles = true;
  // A legend that has no room beside the title takes lines of its own; or the title is shortened
  // first, to a few letters, so that the plot keeps its height while words in the legend change.
  bool titleGivesWay = false;
};

// It has a ground of its own, so that it reads the same on a light and on a dark page.
const PlotTheme& printTheme();

}  // namespace cutis
