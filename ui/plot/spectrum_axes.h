#pragma once

// The frame of the spectrum plot: where wavelength and reflectance lie, the bands with their names,
// and the axes. Wavelengths in nm over the whole grid, reflectance from 0 to maximum, places in the
// widget's pixels.

#include <optional>

#include <QFont>
#include <QRectF>

class QPainter;

namespace cutis {

// Axis texts and steps are chosen for about this many lines.
inline constexpr int kMostReflectanceSteps = 5;

struct SpectrumAxes {
  QRectF area;  // of the curves alone; names of the bands stand above it, numbers beside it
  double maximum = 1;
  QFont font;

  // Room for title, names and numbers taken off `outside`.
  static SpectrumAxes within(const QRectF& outside, double maximum, const QFont& font);

  QPointF pointAt(double wavelengthNm, double reflectance) const;
  // The grid sample nearest to a place; nothing left and right of the area.
  std::optional<int> sampleAt(double x) const;

  void drawBands(QPainter& painter) const;
  void drawReflectances(QPainter& painter) const;
  // One wavelength may stand out in a frame; it takes the place of the numbers that it would touch.
  void drawWavelengths(QPainter& painter, std::optional<double> marked) const;
};

}  // namespace cutis
