#include "src/cli/commands/bench/bench_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "src/cli/plot_style.h"
#include "src/report/scale.h"

namespace cutis {
namespace {

using namespace plot_style;

constexpr double kMarker = 3.6;
constexpr double kTickRoom = 46.0;     // for numbers left of a panel
constexpr double kTitleRoom = 44.0;    // for the row's heading and the panels' titles
constexpr double kFootRoom = 38.0;     // for numbers and title of the axis across
constexpr double kMarginShare = 0.08;  // of a panel, left and right of its points
constexpr std::array<const char*, 2> kContents = {"uncorrelated", "sample"};

struct Series {
  bool filled = true;
  std::vector<double> x;
  std::vector<double> y;  // of values above 0
};

struct Panel {
  const char* title;
  const char* across;
  bool logarithmic;  // upwards; across always is
  bool isSquare;     // numbers across are the side of a square
  std::vector<Series> series;
};

// The pictures as one series for each content; value: what is shown of them, 0 for nothing.
template <typename Across, typename Value>
std::vector<Series> seriesOf(const std::vector<PictureFigures>& pictures, const Across& across,
                             const Value& value) {
  std::vector<Series> all;
  for (const char* content : kContents) {
    Series series;
    series.filled = all.empty();
    for (const PictureFigures& row : pictures) {
      if (row.method != BenchMethod::refinedWide || row.content != content || row.scaled) continue;
      const double up = value(row);
      if (!(up > 0.0)) continue;
      series.x.push_back(across(row));
      series.y.push_back(up);
    }
    all.push_back(series);
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

// As fast as one thread times their number.
void drawIdeal(Drawing& drawing, const Series& series, const Scale& x, const Scale& y) {
  constexpr int steps = 24;
  std::vector<Point> points;
  for (int i = 0; i <= steps; ++i) {
    const double threads =
        series.x.front() * std::pow(series.x.back() / series.x.front(), 1.0 * i / steps);
    points.push_back({x.at(threads), y.at(series.y.front() * series.x.front() / threads)});
  }
  drawing.polyline(points, {kFrameColor, 1.2, "3 3"});
}

void drawSeries(Drawing& drawing, const Series& series, const Scale& x, const Scale& y) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < series.x.size(); ++i)
    points.push_back({x.at(series.x[i]), y.at(series.y[i])});
  drawing.polyline(points, {kRefined, 1.4, series.filled ? "" : "4 3"});
  for (const Point& point : points)
    drawing.disc(point, kMarker, series.filled ? kRefined : kGround, {kRefined, 1.4, ""});
}

void drawPanel(Drawing& drawing, const Box& area, const Panel& panel) {
  drawing.text({area.left, area.top - 10.0}, panel.title, kLabel, Anchor::start);
  const Range up = rangeOf(panel.series, &Series::y), over = rangeOf(panel.series, &Series::x);
  if (up.most == 0.0) {
    drawing.text({area.left, area.top + 20.0}, "not told by this system", kTick, Anchor::start);
    return;
  }
  const auto ticks = panel.logarithmic ? logarithmicTicks(up.least, up.most) : linearTicks(up.most);
  const Scale y = {ticks.front(), ticks.back(), area.bottom, area.top, panel.logarithmic};
  const double margin = kMarginShare * (area.right - area.left);
  const Scale x = {over.least, over.most > over.least ? over.most : 2.0 * over.least,
                   area.left + margin, area.right - margin, true};
  for (const double tick : ticks) {
    drawing.line({area.left, y.at(tick)}, {area.right, y.at(tick)}, kGrid);
    drawing.text({area.left - 6.0, y.at(tick) + 4.0}, formatNumber(tick, 3), kTick, Anchor::end);
  }
  for (const double value : valuesAcross(panel.series)) {
    drawing.line({x.at(value), area.bottom}, {x.at(value), area.bottom + 4.0}, kFrame);
    const std::string words =
        panel.isSquare ? formatNumber(std::sqrt(value), 6) + "²" : formatNumber(value, 6);
    drawing.text({x.at(value), area.bottom + 17.0}, words, kTick, Anchor::middle);
  }
  drawing.line({area.left, area.bottom}, {area.right, area.bottom}, kFrame);
  drawing.text({0.5 * (area.left + area.right), area.bottom + 34.0}, panel.across, kTick,
               Anchor::middle);
  const Series& first = panel.series.front();
  if (!panel.logarithmic && panel.title[0] == 'T' && first.x.size() > 1)
    drawIdeal(drawing, first, x, y);
  for (const Series& series : panel.series)
    drawSeries(drawing, series, x, y);
}

double drawKey(Drawing& drawing, double x, double y, bool filled, const char* words) {
  drawing.line({x, y - 4.0}, {x + 20.0, y - 4.0}, {kRefined, 1.4, filled ? "" : "4 3"});
  drawing.disc({x + 10.0, y - 4.0}, kMarker, filled ? kRefined : kGround, {kRefined, 1.4, ""});
  drawing.text({x + 26.0, y}, words, kLabel, Anchor::start);
  return x + 26.0 + textWidth(words, kLabel.size) + 18.0;
}

}  // namespace

void drawPicturePanels(Drawing& drawing, const Box& area, const BenchFigures& figures) {
  const std::array<Panel, 4> panels = {{
      {"Time, s", "pixels", true, true, seriesOf(figures.sizes, pixelsOf, secondsOf)},
      {"Memory, MB", "pixels", true, true, seriesOf(figures.sizes, pixelsOf, megabytesOf)},
      {"Time, s", "threads", false, false, seriesOf(figures.scaling, threadsOf, secondsOf)},
      {"Memory, MB", "threads", false, false, seriesOf(figures.scaling, threadsOf, megabytesOf)},
  }};
  const char* title = "Time and memory of the refined fit";
  drawing.text({area.left, area.top + 12.0}, title, kSubheading, Anchor::start);
  double x = area.left + 1.15 * textWidth(title, kSubheading.size) + 26.0;
  const double y = area.top + 12.0;
  x = drawKey(drawing, x, y, true, "uncorrelated pixels");
  x = drawKey(drawing, x, y, false, "the sample");
  drawing.line({x, y - 4.0}, {x + 20.0, y - 4.0}, {kFrameColor, 1.2, "3 3"});
  drawing.text({x + 26.0, y}, "ideal", kLabel, Anchor::start);
  const double wide = (area.right - area.left + 14.0) / static_cast<double>(panels.size());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double left = area.left + wide * static_cast<double>(i);
    drawPanel(
        drawing,
        {left + kTickRoom, area.top + kTitleRoom, left + wide - 14.0, area.bottom - kFootRoom},
        panels[i]);
  }
}

}  // namespace cutis
