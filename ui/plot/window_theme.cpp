#include "ui/plot/window_theme.h"

#include <cmath>

#include <QColor>
#include <QLocale>

#include "src/report/plot/ticks.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

Color colorOf(const QColor& color) {
  return Color::rgb(color.rgb());
}

}  // namespace

PlotTheme windowTheme(const PaintFonts& fonts) {
  const theme::Tones& tones = theme::tones();
  PlotTheme plot;
  plot.ground = colorOf(tones.field);
  plot.ink = colorOf(tones.text);
  plot.muted = colorOf(tones.dimText);
  plot.grid = colorOf(tones.gridLine);
  plot.frame = colorOf(tones.line);
  plot.shade = colorOf(tones.plotBand);
  plot.outerShade = colorOf(tones.plotOuterBand);
  plot.series = {colorOf(tones.edited), colorOf(tones.original), Color::rgb(0xc9a0dc),
                 Color::rgb(0xb4bcc6), Color::rgb(0x7fc99a)};
  const double size = fonts.baseSize();
  plot.heading = plot.title = {size, plot.ink, true};
  plot.label = {size, plot.ink, false};
  plot.tick = plot.note = {size, plot.muted, false};
  plot.space = theme::kSpace;
  plot.farSpace = theme::kDoubleSpace;
  // Bands stand out by themselves, and a dock has no room to give away.
  plot.isFramed = false;
  plot.hasAxisTitles = false;
  plot.titleGivesWay = true;
  return plot;
}

Stroke firstCurveStroke(const PlotTheme& theme) {
  return {theme.series.blue, 2.0};
}

Stroke secondCurveStroke(const PlotTheme& theme) {
  return {theme.series.orange, 2.0, 8.0, 5.0};
}

std::string localTickWords(double value, double step) {
  const int decimals = decimalsFor(step);
  const double tiny = 0.5 * std::pow(10.0, -decimals);
  // No "-0.00".
  return QLocale().toString(std::abs(value) < tiny ? 0.0 : value, 'f', decimals).toStdString();
}

}  // namespace cutis
