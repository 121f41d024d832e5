#pragma once  // internal to ui/plot

// Plots of the window: the dark theme's colours, the widget's font and the user's locale.

#include <string>

#include <QString>

#include "src/report/plot/theme.h"
#include "ui/plot/paint_drawing.h"

namespace cutis {

PlotTheme windowTheme(const PaintFonts& fonts);

// The second is dashed, too: never colour alone.
Stroke firstCurveStroke(const PlotTheme& theme);
Stroke secondCurveStroke(const PlotTheme& theme);

// In the user's locale, as many decimals as tell neighbours a `step` apart.
std::string localTickWords(double value, double step);

}  // namespace cutis
