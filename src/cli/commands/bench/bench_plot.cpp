#include "src/cli/commands/bench/bench_plot.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "src/cli/commands/bench/bench_panels.h"
#include "src/cli/commands/bench/bench_remarks.h"
#include "src/cli/plot_style.h"
#include "src/report/label_placement.h"
#include "src/report/scale.h"

namespace cutis {
namespace {

using namespace plot_style;

constexpr double kWidth = 920.0;
constexpr Box kPlot = {78.0, 104.0, 896.0, 436.0};
constexpr Box kPanels = {24.0, 504.0, 896.0, 738.0};
constexpr double kDisc = 5.5;
constexpr double kSquare = 5.0;  // half of its side
constexpr double kRoom = 1.6;    // factor between the outermost points and the edges, at least

constexpr double kNotesTop = kPanels.bottom + 26.0, kNoteLine = 15.0;

struct PlotPoint {
  std::string label;
  double seconds;
  double error;
  bool published;
  bool noisy;
  const char* color;
};

const char* colorOf(BenchMethod method) {
  if (method == BenchMethod::network) return kNetwork;
  return isRefined(method) ? kRefined : kSearch;
}

// With noise: what is made for it. Without: what is not, and what the paper published as such.
bool isDrawnAt(BenchMethod method, bool noisy) {
  if (method == BenchMethod::network) return true;
  return noisy == (isRefined(method) && method != BenchMethod::refinedExact);
}

std::vector<PlotPoint> pointsOf(const BenchFigures& figures) {
  std::vector<PlotPoint> points;
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
                      false, kPaper});
  }
  return points;
}

std::optional<double> boundOf(const BenchFigures& figures) {
  for (const BoundFigures& row : figures.bounds) {
    if (row.noise == kUsualNoise) return row.bound.visible;
  }
  return {};
}

// Whole decades with some room around the points.
Scale decades(const std::vector<PlotPoint>& points, double PlotPoint::*value, double begin,
              double end) {
  const auto [least, most] = std::minmax_element(
      points.begin(), points.end(),
      [&](const PlotPoint& a, const PlotPoint& b) { return a.*value < b.*value; });
  return {std::pow(10.0, std::floor(std::log10((*least).*value / kRoom))),
          std::pow(10.0, std::ceil(std::log10((*most).*value * kRoom))), begin, end, true};
}

int decadeOf(double value) {
  return static_cast<int>(std::lround(std::log10(value)));
}

void drawAxes(Drawing& drawing, const Scale& x, const Scale& y) {
  for (int t = decadeOf(x.from); t <= decadeOf(x.to); ++t) {
    const double at = x.at(std::pow(10.0, t));
    drawing.line({at, kPlot.top}, {at, kPlot.bottom}, kGrid);
    if (t < -1 || t > 3) {
      drawing.powerOfTen({at, kPlot.bottom + 18.0}, t, kTick, Anchor::middle);
    } else {
      drawing.text({at, kPlot.bottom + 18.0}, formatNumber(std::pow(10.0, t), 6), kTick,
                   Anchor::middle);
    }
  }
  for (int e = decadeOf(y.from); e <= decadeOf(y.to); ++e) {
    const double at = y.at(std::pow(10.0, e));
    drawing.line({kPlot.left, at}, {kPlot.right, at}, kGrid);
    drawing.powerOfTen({kPlot.left - 8.0, at + 4.0}, e, kTick, Anchor::end);
  }
  // What people count long times in.
  const std::vector<std::pair<double, const char*>> units = {
      {60.0, "1 min"}, {3600.0, "1 h"}, {86400.0, "1 day"}};
  for (const auto& [seconds, name] : units) {
    if (seconds <= x.from || seconds >= x.to) continue;
    drawing.line({x.at(seconds), kPlot.top}, {x.at(seconds), kPlot.top + 6.0}, kFrame);
    drawing.text({x.at(seconds), kPlot.top - 6.0}, name, kTick, Anchor::middle);
  }
  drawing.rectangle(kPlot, "none", kFrame);
  drawing.text({0.5 * (kPlot.left + kPlot.right), kPlot.bottom + 40.0},
               "time for 2048² uncorrelated pixels, s", kLabel, Anchor::middle);
  drawing.textUpwards({24.0, 0.5 * (kPlot.top + kPlot.bottom)},
                      "mean squared error of reflectance, 400–700 nm", kLabel);
}

void drawMarker(Drawing& drawing, Point at, bool published, bool open, const char* color) {
  const char* fill = open ? kGround : color;
  // A rim of ground keeps markers apart that lie on each other.
  drawing.disc(at, kDisc + 2.4, kGround, kNoStroke);
  if (published) {
    drawing.rectangle({at.x - kSquare, at.y - kSquare, at.x + kSquare, at.y + kSquare}, fill,
                      {color, 1.8, ""});
  } else {
    drawing.disc(at, kDisc, fill, {color, 1.8, ""});
  }
}

// What no label may lie on: the line of the bound and its name.
std::vector<Box> drawBound(Drawing& drawing, const BenchFigures& figures, const Scale& y) {
  const auto bound = boundOf(figures);
  if (!bound) return {};
  const double at = y.at(*bound);
  drawing.line({kPlot.left, at}, {kPlot.right, at}, {kBound, 1.6, "7 4"});
  TextStyle style = kLabel;
  style.color = kBound;
  const std::string words = "Bayesian Cramér–Rao bound at 0.5 % noise";
  drawing.text({kPlot.right - 10.0, at - 7.0}, words, style, Anchor::end);
  const double left = kPlot.right - 12.0 - textWidth(words, style.size);
  return {{kPlot.left, at - 2.0, kPlot.right, at + 2.0}, {left, at - 20.0, kPlot.right, at}};
}

void drawPoints(Drawing& drawing, const std::vector<PlotPoint>& points, const Scale& x,
                const Scale& y, const std::vector<Box>& taken) {
  std::vector<LabelledPoint> places;
  for (const PlotPoint& point : points)
    places.push_back({{x.at(point.seconds), y.at(point.error)}, kDisc + 1.0, point.label});
  const Box area = {kPlot.left + 4.0, kPlot.top + 8.0, kPlot.right - 4.0, kPlot.bottom - 4.0};
  const auto labels = placeLabels(places, taken, area, kLabel.size);
  for (const PlacedLabel& label : labels) {
    if (label.hasLeader) drawing.line(label.leaderFrom, label.leaderTo, kFrame);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    drawMarker(drawing, places[i].at, points[i].published, points[i].noisy, points[i].color);
    TextStyle style = kLabel;
    style.color = points[i].color;
    drawing.text(labels[i].at, points[i].label, style, labels[i].anchor);
  }
}

void drawKey(Drawing& drawing) {
  double x = kPlot.left + 6.0;
  const double y = 74.0;
  const auto entry = [&](bool published, bool open, const char* color, const char* words) {
    drawMarker(drawing, {x, y - 4.0}, published, open, color);
    drawing.text({x + 12.0, y}, words, kLabel, Anchor::start);
    x += 12.0 + textWidth(words, kLabel.size) + 26.0;
  };
  entry(false, true, kInk, "0.5 % noise");
  entry(false, false, kInk, "no noise");
  entry(true, false, kPaper, "published by the paper, no noise");
}

std::string described(const std::vector<PlotPoint>& points) {
  std::string text = "Time for 2048 by 2048 pixels and mean squared error, 400 to 700 nm.";
  for (const PlotPoint& point : points) {
    text += " " + point.label + ": " + formatNumber(point.seconds, 3) + " s, " +
            shortScientific(point.error) + (point.noisy ? " at 0.5 % noise." : ".");
  }
  return text;
}

// Words as lines that fit a width.
std::vector<std::string> wrapped(const std::string& words, double size, double width) {
  std::vector<std::string> lines(1);
  for (std::size_t from = 0; from < words.size();) {
    const std::size_t end = std::min(words.find(' ', from), words.size());
    const std::string word = words.substr(from, end - from);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (textWidth(longer, size) > width && !lines.back().empty()) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
    from = end + 1;
  }
  return lines;
}

// What stands below the panels, as lines.
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
  std::vector<std::string> lines;
  for (const std::string& note : notes) {
    const auto more = wrapped(note, kNote.size, kPanels.right - kPanels.left);
    lines.insert(lines.end(), more.begin(), more.end());
  }
  return lines;
}

void drawNotes(Drawing& drawing, const std::vector<std::string>& lines) {
  double y = kNotesTop;
  for (const std::string& line : lines) {
    drawing.text({kPanels.left, y}, line, kNote, Anchor::start);
    y += kNoteLine;
  }
}

}  // namespace

Drawing benchPlot(const BenchFigures& figures) {
  const auto points = pointsOf(figures);
  const auto notes = notesOf(figures);
  const double height = kNotesTop + kNoteLine * static_cast<double>(notes.size()) + 2.0;
  Drawing drawing(kWidth, height, "Run time against error", described(points));
  drawing.rectangle({0.5, 0.5, kWidth - 0.5, height - 0.5}, kGround, {kGridColor, 1.0, ""}, 6.0);
  drawing.text({kPanels.left, 32.0}, "Run time against error", kHeading, Anchor::start);
  drawing.text({kPanels.left, 51.0},
               "Fits of simulated photographs under three lights; the lower left corner is best",
               kTick, Anchor::start);
  drawKey(drawing);
  const Scale x = decades(points, &PlotPoint::seconds, kPlot.left, kPlot.right);
  const Scale y = decades(points, &PlotPoint::error, kPlot.bottom, kPlot.top);
  drawAxes(drawing, x, y);
  const auto taken = drawBound(drawing, figures, y);
  drawPoints(drawing, points, x, y, taken);
  drawPicturePanels(drawing, kPanels, figures);
  drawNotes(drawing, notes);
  return drawing;
}

}  // namespace cutis
