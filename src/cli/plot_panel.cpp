#include "src/cli/plot_panel.h"

#include <cmath>

#include "core/base/number_text.h"
#include "src/cli/plot_style.h"

namespace cutis {

using namespace plot_style;

namespace {

constexpr double kKeyLength = 26.0;

std::string signedNumber(double value) {
  return (value < 0.0 ? "−" : "") + formatNumber(std::abs(value), 6);
}

}  // namespace

PlotPanel plotPanel(const Box& box, double fromX, double toX, double fromY, double toY) {
  return {box, {fromX, toX, box.left, box.right}, {fromY, toY, box.bottom, box.top}};
}

PlotPanel decadePanel(const Box& box, double fromX, double toX, double least, double most) {
  PlotPanel panel = plotPanel(box, fromX, toX, std::pow(10.0, std::floor(std::log10(least))),
                              std::pow(10.0, std::ceil(std::log10(most))));
  panel.y.logarithmic = true;
  return panel;
}

void drawDecades(Drawing& drawing, const PlotPanel& panel) {
  const auto exponent = [](double value) { return std::lround(std::log10(value)); };
  for (long e = exponent(panel.y.from); e <= exponent(panel.y.to); ++e) {
    const double at = panel.y.at(std::pow(10.0, static_cast<double>(e)));
    drawing.line({panel.box.left, at}, {panel.box.right, at}, kGrid);
    drawing.powerOfTen({panel.box.left - 8.0, at + 4.0}, static_cast<int>(e), kTick, Anchor::end);
  }
}

void drawAcross(Drawing& drawing, const PlotPanel& panel, const std::vector<double>& ticks) {
  for (const double tick : ticks) {
    if (tick > panel.x.to) continue;
    const double at = panel.x.at(tick);
    drawing.line({at, panel.box.top}, {at, panel.box.bottom}, kGrid);
    drawing.text({at, panel.box.bottom + 16.0}, signedNumber(tick), kTick, Anchor::middle);
  }
}

void drawUpwards(Drawing& drawing, const PlotPanel& panel, const std::vector<double>& ticks) {
  for (const double tick : ticks) {
    const double at = panel.y.at(tick);
    drawing.line({panel.box.left, at}, {panel.box.right, at}, tick == 0.0 ? kFrame : kGrid);
    drawing.text({panel.box.left - 8.0, at + 4.0}, signedNumber(tick), kTick, Anchor::end);
  }
}

void drawFrame(Drawing& drawing, const PlotPanel& panel, const std::string& title,
               const std::string& across) {
  drawing.rectangle(panel.box, "none", kFrame);
  drawing.text({panel.box.left, panel.box.top - 9.0}, title, kSubheading, Anchor::start);
  drawing.text({0.5 * (panel.box.left + panel.box.right), panel.box.bottom + 34.0}, across, kLabel,
               Anchor::middle);
}

void drawCurve(Drawing& drawing, const PlotPanel& panel, const std::vector<double>& across,
               const std::vector<double>& values, const Stroke& stroke) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < values.size(); ++i)
    points.push_back(panel.at(across[i], values[i]));
  drawing.polyline(points, stroke);
}

void drawKey(Drawing& drawing, Point at, const Stroke& stroke, const std::string& words) {
  drawing.line({at.x, at.y - 4.0}, {at.x + kKeyLength, at.y - 4.0}, stroke);
  drawing.text({at.x + kKeyLength + 7.0, at.y}, words, kTick, Anchor::start);
}

}  // namespace cutis
