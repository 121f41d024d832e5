#include "src/cli/commands/bench/bench_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/number_text.h"

namespace cutis {
namespace {

constexpr double kRowHeight = 150.0;
constexpr double kSmallMarker = 4.3;
constexpr double kMarginFactor = 1.12;  // between the outermost points and the sides
constexpr int kSteps = 5;
constexpr std::array<const char*, 2> kContents = {"uncorrelated", "sample"};

struct Series {
  std::vector<double> x;
  std::vector<double> y;  // of values above 0
};

// The pictures as one series for each content; value: what is shown of them, 0 for nothing.
template <typename Across, typename Value>
std::vector<Series> seriesOf(const std::vector<PictureFigures>& pictures, const Across& across,
                             const Value& value) {
  std::vector<Series> all;
  for (const char* content : kContents) {
    Series series;
    for (const PictureFigures& row : pictures) {
      if (row.method != BenchMethod::refinedWide || row.content != content || row.scaled) continue;
      const double up = value(row);
      if (!(up > 0.0)) continue;
      series.x.push_back(across(row));
      series.y.push_back(up);
    }
    all.push_back(std::move(series));
  }
  return all;
}

double pixelsOf(const PictureFigures& row) {
  return 1.0 * row.size * row.size;
}
double threadsOf(const PictureFigures& row) {
  return row.threads;
}
double secondsOf(const PictureFigures& row) {
  return row.seconds;
}
double megabytesOf(const PictureFigures& row) {
  return row.memoryBytes ? static_cast<double>(*row.memoryBytes) / 0x1p20 : 0.0;
}

// Both 0 where there are no values.
struct Range {
  double least = 0.0, most = 0.0;
};

Range rangeOf(const std::vector<Series>& all, std::vector<double> Series::*values) {
  Range range;
  for (const Series& series : all) {
    for (const double value : series.*values) {
      range.least = range.most == 0.0 ? value : std::min(range.least, value);
      range.most = std::max(range.most, value);
    }
  }
  return range;
}

// Numbers across: every value there is.
std::vector<double> valuesAcross(const std::vector<Series>& all) {
  std::vector<double> values;
  for (const Series& series : all)
    values.insert(values.end(), series.x.begin(), series.x.end());
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

Stroke strokeOf(bool first) {
  return {printTheme().series.orange, 1.4, first ? 0.0 : 4.0, first ? 0.0 : 3.0};
}
Marker markerOf(bool first) {
  return {printTheme().series.orange, kSmallMarker, first};
}
Stroke idealStroke() {
  return {printTheme().series.grey, 1.2, 3.0, 3.0};
}

// As fast as one thread times their number.
Curve idealCurve(const Series& series) {
  constexpr int steps = 24;
  Curve curve;
  curve.stroke = idealStroke();
  for (int i = 0; i <= steps; ++i) {
    const double threads =
        series.x.front() * std::pow(series.x.back() / series.x.front(), 1.0 * i / steps);
    curve.x.push_back(threads);
    curve.y.push_back(series.y.front() * series.x.front() / threads);
  }
  return curve;
}

std::string squareWords(double pixels) {
  return formatNumber(std::sqrt(pixels), 6) + "²";
}
std::string countWords(double count) {
  return formatNumber(count, 6);
}

// Logarithmic, with a number at every value there is.
Axis axisAcross(const std::vector<Series>& all, std::string (*words)(double)) {
  const Range range = rangeOf(all, &Series::x);
  Axis axis;
  axis.logarithmic = true;
  axis.hasGrid = false;
  axis.from = range.least / kMarginFactor;
  axis.to = (range.most > range.least ? range.most : 2.0 * range.least) * kMarginFactor;
  for (const double value : valuesAcross(all))
    axis.ticks.push_back({value, words(value), {}, false});
  return axis;
}

Panel panelOf(const char* title, const std::vector<Series>& all, const Axis& across) {
  Panel panel;
  panel.title = title;
  panel.x = across;
  if (rangeOf(all, &Series::y).most == 0.0) {
    panel.message = "unknown on this system";
    return panel;
  }
  for (const Series& series : all) {
    const bool first = &series == &all.front();
    panel.curves.push_back({series.x, series.y, strokeOf(first), markerOf(first)});
  }
  return panel;
}

template <typename Value>
Panel panelBySize(const BenchFigures& figures, const char* title, const Value& value) {
  const auto all = seriesOf(figures.sizes, pixelsOf, value);
  Axis across = axisAcross(all, squareWords);
  across.title = "pixels";
  Panel panel = panelOf(title, all, across);
  const Range up = rangeOf(all, &Series::y);
  if (up.most == 0.0) return panel;
  const auto [from, to] = roundEnds(up.least, up.most);
  panel.y = logarithmicAxis(from, to);
  return panel;
}

template <typename Value>
Panel panelByThreads(const BenchFigures& figures, const char* title, const Value& value) {
  const auto all = seriesOf(figures.scaling, threadsOf, value);
  Axis across = axisAcross(all, countWords);
  across.title = "threads";
  Panel panel = panelOf(title, all, across);
  const Range up = rangeOf(all, &Series::y);
  if (up.most > 0.0) panel.y = linearAxis(0.0, niceCeiling(up.most, kSteps), kSteps);
  return panel;
}

}  // namespace

PanelRow pictureRow(const BenchFigures& figures) {
  PanelRow row;
  row.title = "Time and memory of the refined fit";
  row.height = kRowHeight;
  row.legend = {{"uncorrelated pixels", strokeOf(true), markerOf(true)},
                {"the sample", strokeOf(false), markerOf(false)},
                {"ideal", idealStroke(), {}}};
  row.panels = {panelBySize(figures, "Time, s", secondsOf),
                panelBySize(figures, "Memory, MB", megabytesOf),
                panelByThreads(figures, "Time, s", secondsOf),
                panelByThreads(figures, "Memory, MB", megabytesOf)};
  const Series times = seriesOf(figures.scaling, threadsOf, secondsOf).front();
  if (times.x.size() > 1) {
    auto& curves = row.panels[2].curves;
    curves.insert(curves.begin(), idealCurve(times));
  }
  return row;
}

}  // namespace cutis
