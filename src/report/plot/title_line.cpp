#include "src/report/plot/title_line.h"

#include <algorithm>

namespace cutis {
namespace {

constexpr double kSample = 24.0;        // length of a piece of line
constexpr double kSampleGap = 6.0;      // between sample and words
constexpr double kMarkerRim = 1.6;      // of a marker's outline
constexpr double kLargestMarker = 4.5;  // in a legend
constexpr double kShortestTitle = 8.0;  // sizes of its letters: what is shorter says nothing
constexpr double kMiddle = 0.36;        // of small letters above their baseline

double sampleWidth(const LegendEntry& entry) {
  if (!entry.stroke.color.isNone()) return kSample;
  return entry.marker ? 2.0 * std::min(entry.marker->radius, kLargestMarker) + kMarkerRim : 0.0;
}

double entryWidth(const LegendEntry& entry, const PlotTheme& theme, const TextMetrics& metrics) {
  return sampleWidth(entry) + kSampleGap + metrics.width(entry.words, theme.label);
}

using LegendRow = std::vector<const LegendEntry*>;

double rowWidth(const LegendRow& row, const PlotTheme& theme, const TextMetrics& metrics) {
  double width = -theme.farSpace;
  for (const LegendEntry* entry : row)
    width += entryWidth(*entry, theme, metrics) + theme.farSpace;
  return width;
}

LegendRow wholeLegend(const TitleLine& line) {
  LegendRow row;
  for (const LegendEntry& entry : line.legend)
    row.push_back(&entry);
  return row;
}

// Whether the legend stands in the title's own line.
bool isBeside(const TitleLine& line, double width, const PlotTheme& theme,
              const TextMetrics& metrics) {
  if (line.legend.empty() || line.title.empty()) return true;
  const double legend = rowWidth(wholeLegend(line), theme, metrics);
  double title = metrics.width(line.title, line.style);
  if (theme.titleGivesWay) title = std::min(title, kShortestTitle * line.style.size);
  return title + theme.farSpace + legend <= width;
}

// The legend in as few rows as hold it.
std::vector<LegendRow> legendRows(const TitleLine& line, double width, const PlotTheme& theme,
                                  const TextMetrics& metrics) {
  if (line.legend.empty()) return {};
  std::vector<LegendRow> rows(1);
  for (const LegendEntry& entry : line.legend) {
    LegendRow longer = rows.back();
    longer.push_back(&entry);
    if (longer.size() > 1 && rowWidth(longer, theme, metrics) > width) {
      rows.push_back({&entry});
    } else {
      rows.back() = longer;
    }
  }
  return rows;
}

double legendGap(const PlotTheme& theme) {
  return 0.25 * theme.space;
}

double legendLine(const PlotTheme& theme, const TextMetrics& metrics) {
  return metrics.height(theme.label) + legendGap(theme);
}

void drawRow(Drawing& drawing, const LegendRow& row, Point baseline, const PlotTheme& theme,
             const TextMetrics& metrics) {
  double x = baseline.x;
  for (const LegendEntry* entry : row) {
    const double sample = sampleWidth(*entry);
    const double middle = baseline.y - kMiddle * theme.label.size;
    if (!entry->stroke.color.isNone())
      drawing.line({x, middle}, {x + sample, middle}, entry->stroke);
    if (entry->marker) {
      Marker marker = *entry->marker;
      marker.radius = std::min(marker.radius, kLargestMarker);
      drawMarker(drawing, {x + 0.5 * sample, middle}, marker, 0.0, theme.ground);
    }
    drawing.add(Text{{x + sample + kSampleGap, baseline.y}, entry->words, theme.label});
    x += entryWidth(*entry, theme, metrics) + theme.farSpace;
  }
}

}  // namespace

double titleHeight(const TitleLine& line, double width, const PlotTheme& theme,
                   const TextMetrics& metrics) {
  const auto rows = static_cast<double>(legendRows(line, width, theme, metrics).size());
  const double title = line.title.empty() ? 0.0 : metrics.height(line.style);
  if (rows == 0.0) return title;
  const double legend = rows * legendLine(theme, metrics) - legendGap(theme);
  return isBeside(line, width, theme, metrics) ? std::max(title, legend)
                                               : title + legendGap(theme) + legend;
}

void drawTitle(Drawing& drawing, const TitleLine& line, Point at, double width,
               const PlotTheme& theme, const TextMetrics& metrics) {
  const auto rows = legendRows(line, width, theme, metrics);
  const bool beside = isBeside(line, width, theme, metrics);
  double room = width;
  double baseline = at.y + metrics.ascent(theme.label);
  if (!rows.empty() && !line.title.empty()) {
    const double legend = rowWidth(rows.front(), theme, metrics);
    if (beside) {
      room -= legend + theme.farSpace;
      baseline = at.y + metrics.ascent(line.style);
      drawRow(drawing, rows.front(), {at.x + width - legend, baseline}, theme, metrics);
    } else {
      baseline += metrics.height(line.style) + legendGap(theme);
    }
  }
  if (!line.title.empty()) {
    drawing.add(Text{{at.x, at.y + metrics.ascent(line.style)},
                     shortened(line.title, line.style, std::max(room, 0.0), metrics),
                     line.style});
    if (beside) return;
  }
  for (const LegendRow& row : rows) {
    drawRow(drawing, row, {at.x, baseline}, theme, metrics);
    baseline += legendLine(theme, metrics);
  }
}

void drawMarker(Drawing& drawing, Point at, const Marker& marker, double rim, Color ground) {
  const Color fill = marker.isFilled ? marker.color : ground;
  const Stroke outline = {marker.color, kMarkerRim};
  const double reach = marker.radius;
  if (rim > 0.0) drawing.add(Disc{at, reach + rim, ground, kNoStroke});
  if (marker.shape == Shape::disc) {
    drawing.add(Disc{at, reach - 0.5 * kMarkerRim, fill, outline});
  } else {
    const double half = reach - 0.5 * kMarkerRim;
    drawing.add(
        Rectangle{{at.x - half, at.y - half, at.x + half, at.y + half}, fill, outline, 0.0});
  }
}

}  // namespace cutis
