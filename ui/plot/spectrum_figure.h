#pragma once

// What a plot of reflectance spectra shows, and the panel that shows it, in the window or on paper.
//
// Curves have a value per sample of core/spectra/grid.h; empty ones are not there. Reflectance is a
// share: 0 none, 1 a perfect diffuser; NaN leaves a gap. Where the photographs measured nothing
// curves are drawn dashed and the ground is darker. Bars and bands reach two standard deviations to
// either side, 95 % where errors are normal.

#include <functional>
#include <optional>
#include <vector>

#include <QString>
#include <QVector>

#include "core/spectra/grid.h"
#include "src/report/plot/panel.h"
#include "src/report/plot/theme.h"

namespace cutis {

// One channel of the photographs, as reflectance.
struct MeasuredChannel {
  QString name;             // "white.G"
  double wavelengthNm = 0;  // the mean of its response
  double halfWidthNm = 0;   // of its response; drawn as a bar across
  double reflectance = 0;
  double deviation = 0;  // standard deviation of the noise
  double modelled = 0;   // what the curve gives in this channel
};

// The spectra of one place.
struct PlaceCurves {
  QVector<double> original;
  QVector<double> edited;     // empty: not edited
  QVector<double> deviation;  // of the original; empty: not known
};

struct PinnedCurves {
  QString letter;  // "A"
  QString name;    // "cheek"; may be empty
  int number = 0;  // of its colour
  PlaceCurves curves;
};

struct NamedCurve {
  QString name;
  QVector<double> values;
};

// Instead of reflectance: absorption in mm⁻¹ on a logarithmic axis, or shares of reflectance that
// each chromophore takes.
enum class SpectrumQuantity { reflectance, absorption, contributions };

struct SpectrumFigure {
  QString title;
  SpectrumQuantity quantity = SpectrumQuantity::reflectance;
  std::vector<NamedCurve> parts;  // of another quantity: all that is drawn
  PlaceCurves place;              // under the cursor
  std::vector<PinnedCurves> pins;
  std::vector<NamedCurve> references;  // spectra from files
  QVector<MeasuredChannel> channels;
  std::optional<Band> measured;  // none: it is not known what was measured
  double maximum = 1;            // of the axis
};

// Whether there is any curve.
bool hasCurves(const SpectrumFigure& figure);
// The largest value that the figure shows; 0 where there is none.
double largestValue(const SpectrumFigure& figure);

// What of a figure is not its own: how it is drawn, and where somebody points.
struct FigureLook {
  const PlotTheme& theme;
  TickWords words;
  std::function<Color(int number)> pinColor;
  bool isPrinted = false;           // axes have names
  std::optional<int> crosshair;     // a sample
  std::optional<double> pointedAt;  // a reflectance
};

Panel panelOf(const SpectrumFigure& figure, const FigureLook& look);

}  // namespace cutis
