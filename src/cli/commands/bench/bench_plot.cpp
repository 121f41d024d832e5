#include "src/cli/commands/bench/bench_plot.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "src/cli/commands/bench/bench_panels.h"
#include "src/cli/commands/bench/bench_remarks.h"
#include "src/report/plot/page.h"

namespace cutis {
namespace {

constexpr double kPanelHeight = 332.0;
constexpr double kMarker = 6.4;
constexpr double kRoom = 1.6;  // factor between the outermost points and the edges, at least

struct MethodPoint {
  std::string label;
  double seconds;
  double error;
  bool published;
  bool noisy;
  Color color;
};

Color colorOf(BenchMethod method) {
  const SeriesColors& colors = printTheme().series;
  if (method == BenchMethod::network) return colors.purple;
  return isRefined(method) ? colors.orange : colors.grey;
}

// With noise: what is made for it. Without: what is not, and what the paper published as such.
bool isDrawnAt(BenchMethod method, bool noisy) {
  if (method == BenchMethod::network) return true;
  return noisy == (isRefined(method) && method != BenchMethod::refinedExact);
}

std::vector<MethodPoint> pointsOf(const BenchFigures& figures) {
  std::vector<MethodPoint> points;
  for (const BenchMethod method : kBenchMethods) {
    const auto seconds = usualSeconds(figures, method);
    for (const bool noisy : {true, false}) {
      const auto* row = figuresOf(figures.methods, method, noisy ? kUsualNoise : 0.0);
      if (row == nullptr || !seconds || !isDrawnAt(method, noisy)) continue;
      points.push_back({methodLabel(method) + std::string(isExhaustive(method) ? " (scaled)" : ""),
                        *seconds, row->errors.visibleMse, false, noisy, colorOf(method)});
    }
  }
  for (const PublishedFigures& row : kPublished) {
    points.push_back({"paper: " + std::string(row.method), row.secondsFor2048, row.visibleMse, true,
                      false, printTheme().series.blue});
  }
  return points;
}

std::optional<double> boundOf(const BenchFigures& figures) {
  for (const BoundFigures& row : figures.bounds) {
    if (row.noise == kUsualNoise) return row.bound.visible;
  }
  return {};
}

Level boundLevel(double bound) {
  const Color color = printTheme().series.green;
  return {bound, {color, 1.6, 7.0, 4.0}, "Bayesian Cramér–Rao bound at 0.5 % noise"};
}

// Whole decades with some room around the points.
Axis decades(const std::vector<MethodPoint>& points, double MethodPoint::*value) {
  const auto [least, most] = std::minmax_element(
      points.begin(), points.end(),
      [&](const MethodPoint& a, const MethodPoint& b) { return a.*value < b.*value; });
  return decadeAxis((*least).*value / kRoom, (*most).*value * kRoom);
}

// Seconds are read more easily as numbers, where these are short.
Axis timeAxis(const std::vector<MethodPoint>& points) {
  Axis axis = decades(points, &MethodPoint::seconds);
  axis.title = "time for 2048² uncorrelated pixels";
  axis.unit = "s";
  for (Tick& tick : axis.ticks) {
    if (tick.value > 0.05 && tick.value < 2000.0)
      tick = {tick.value, formatNumber(tick.value, 6), {}, false};
  }
  return axis;
}

Marker markerOf(const MethodPoint& point) {
  return {point.color, kMarker, !point.noisy, point.published ? Shape::square : Shape::disc};
}

Panel methodPanel(const std::vector<MethodPoint>& points, const BenchFigures& figures) {
  const Color ink = printTheme().ink;
  Panel panel;
  panel.legend = {{"0.5 % noise", kNoStroke, Marker{ink, kMarker, false}},
                  {"no noise", kNoStroke, Marker{ink, kMarker}},
                  {"published by the paper, no noise", kNoStroke,
                   Marker{printTheme().series.blue, kMarker, true, Shape::square}}};
  panel.x = timeAxis(points);
  panel.y = decades(points, &MethodPoint::error);
  panel.y.title = "mean squared error of reflectance, 400–700 nm";
  // What people count long times in.
  panel.above = {
      {60.0, "1 min", {}, false}, {3600.0, "1 h", {}, false}, {86400.0, "1 day", {}, false}};
  if (const auto bound = boundOf(figures)) panel.levels = {boundLevel(*bound)};
  for (const MethodPoint& point : points) {
    PlotPoint shown;
    shown.x = point.seconds;
    shown.y = point.error;
    shown.marker = markerOf(point);
    shown.label = point.label;
    panel.points.push_back(shown);
  }
  return panel;
}

std::string described(const std::vector<MethodPoint>& points) {
  std::string text = "Time for 2048 by 2048 pixels and mean squared error, 400 to 700 nm.";
  for (const MethodPoint& point : points) {
    text += " " + point.label + ": " + formatNumber(point.seconds, 3) + " s, " +
            shortScientific(point.error) + (point.noisy ? " at 0.5 % noise." : ".");
  }
  return text;
}

// What stands below the panels.
std::vector<std::string> notesOf(const BenchFigures& figures) {
  const std::string processor = figures.processor.empty() ? "unknown processor" : figures.processor;
  std::vector<std::string> notes = noiseRemarks(figures);
  notes.push_back("Measured on " + processor + ", " + figures.instructionSet + ", " +
                  std::to_string(figures.threads) +
                  (figures.threads == 1 ? " thread" : " threads") +
                  "; the paper's times on a Titan X. Profile " + figures.profile + ", rig " +
                  figures.rig + ", cutis " + figures.version + ".");
  notes.push_back("Exhaustive searches are scaled from " + std::to_string(figures.subsample) +
                  " pixels. Memory is what the fit holds besides the photographs.");
  return notes;
}

}  // namespace

Drawing benchPlot(const BenchFigures& figures) {
  const auto points = pointsOf(figures);
  Page page;
  page.heading = "Run time against error";
  page.description = described(points);
  page.introduction = {
      "Fits of simulated photographs under three lights; the lower left corner is best"};
  PanelRow methods;
  methods.height = kPanelHeight;
  methods.panels = {methodPanel(points, figures)};
  page.rows = {methods, pictureRow(figures)};
  page.notes = notesOf(figures);
  return layOut(page);
}

}  // namespace cutis
