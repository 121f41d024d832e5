#include <algorithm>
#include <cmath>

#include "src/report/plot/clipping.h"
#include "src/report/plot/label_placement.h"
#include "src/report/plot/panel_drawing.h"
#include "src/report/plot/tick_labels.h"
#include "src/report/plot/title_line.h"

namespace cutis {
namespace {

constexpr double kRim = 1.5;       // of ground around a marker
constexpr double kLevelGap = 5.0;  // between a level and its words
constexpr double kLevelClear = 2.0;

bool isIn(const Box& area, Point p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && area.holds(p);
}

void addClipped(Drawing& drawing, const std::vector<Point>& points, const Box& area,
                const Stroke& stroke) {
  for (std::vector<Point>& piece : clipped(points, area))
    drawing.add(Polyline{std::move(piece), stroke});
}

// One piece without gaps; what lies beyond the area is put at its rim.
void addRibbonPiece(Drawing& drawing, const std::vector<Point>& high, const std::vector<Point>& low,
                    const Box& area, Color color) {
  if (high.size() < 2) return;
  Area outline;
  outline.fill = color;
  outline.points = high;
  outline.points.insert(outline.points.end(), low.rbegin(), low.rend());
  for (Point& p : outline.points) {
    p.x = std::clamp(p.x, area.left, area.right);
    p.y = std::clamp(p.y, area.top, area.bottom);
  }
  drawing.add(std::move(outline));
}

void drawRibbon(Drawing& drawing, const Ribbon& ribbon, const PanelLayout& layout) {
  std::vector<Point> high, low;
  const std::size_t count = std::min({ribbon.x.size(), ribbon.low.size(), ribbon.high.size()});
  for (std::size_t i = 0; i < count; ++i) {
    const Point up = layout.at(ribbon.x[i], ribbon.high[i]);
    const Point down = layout.at(ribbon.x[i], ribbon.low[i]);
    if (std::isfinite(up.x) && std::isfinite(up.y) && std::isfinite(down.y)) {
      high.push_back(up);
      low.push_back(down);
      continue;
    }
    addRibbonPiece(drawing, high, low, layout.area, ribbon.color);
    high.clear();
    low.clear();
  }
  addRibbonPiece(drawing, high, low, layout.area, ribbon.color);
}

// What no label may lie on: the line and its words.
std::vector<Box> drawLevel(Drawing& drawing, const Level& level, const PanelLayout& layout,
                           const PlotTheme& theme, const TextMetrics& metrics) {
  const Box& area = layout.area;
  const double at = layout.y.at(level.value);
  if (!isIn(area, {area.left, at})) return {};
  drawing.line({area.left, at}, {area.right, at}, level.stroke);
  std::vector<Box> taken = {{area.left, at - kLevelClear, area.right, at + kLevelClear}};
  if (level.words.empty()) return taken;
  TextStyle style = theme.label;
  style.color = level.stroke.color;
  const double right = area.right - theme.space;
  // Below the line where there is no room above it.
  const bool above = at - kLevelGap - metrics.ascent(style) >= area.top;
  const double baseline = above ? at - kLevelGap : at + kLevelGap + metrics.ascent(style);
  drawing.add(Text{{right, baseline}, level.words, style, Anchor::end});
  taken.push_back({right - metrics.width(level.words, style) - kLevelClear,
                   baseline - metrics.ascent(style), area.right,
                   baseline + metrics.descent(style)});
  return taken;
}

std::vector<Point> placesOf(const Curve& curve, const PanelLayout& layout) {
  std::vector<Point> places;
  const std::size_t count = std::min(curve.x.size(), curve.y.size());
  for (std::size_t i = 0; i < count; ++i)
    places.push_back(layout.at(curve.x[i], curve.y[i]));
  return places;
}

// Markers that labels have to keep clear of are added to `obstacles`.
void drawCurve(Drawing& drawing, const Curve& curve, const PanelLayout& layout,
               const PlotTheme& theme, std::vector<LabelledPoint>& obstacles) {
  const std::vector<Point> places = placesOf(curve, layout);
  addClipped(drawing, places, layout.area, curve.stroke);
  if (!curve.marker) return;
  for (const Point& place : places) {
    if (!isIn(layout.area, place)) continue;
    drawMarker(drawing, place, *curve.marker, 0.0, theme.ground);
    obstacles.push_back({place, curve.marker->radius, {}});
  }
}

void drawBars(Drawing& drawing, const PlotPoint& point, const PanelLayout& layout) {
  const Stroke stroke = {point.marker.color, point.barWidth};
  addClipped(drawing, {layout.at(point.across.low, point.y), layout.at(point.across.high, point.y)},
             layout.area, stroke);
  addClipped(drawing,
             {layout.at(point.x, point.upwards.low), layout.at(point.x, point.upwards.high)},
             layout.area, stroke);
}

// Bars and leaders below all markers, labels above.
void drawPoints(Drawing& drawing, const Panel& panel, const PanelLayout& layout,
                std::vector<LabelledPoint> obstacles, const std::vector<Box>& taken,
                const PlotTheme& theme, const TextMetrics& metrics) {
  std::vector<const PlotPoint*> shown;
  std::vector<LabelledPoint> places;
  for (const PlotPoint& point : panel.points) {
    const Point place = layout.at(point.x, point.y);
    if (!isIn(layout.area, place)) continue;
    shown.push_back(&point);
    places.push_back({place, point.marker.radius + 1.0, point.label});
    drawBars(drawing, point, layout);
  }
  places.insert(places.end(), obstacles.begin(), obstacles.end());
  const bool anyLabel = std::any_of(places.begin(), places.end(), [](const LabelledPoint& place) {
    return !place.label.empty();
  });
  std::vector<PlacedLabel> labels(places.size());
  if (anyLabel) {
    const Box& area = layout.area;
    labels =
        placeLabels(places, taken,
                    {area.left + 4.0, area.top + theme.space, area.right - 4.0, area.bottom - 4.0},
                    theme.label, metrics);
  }
  for (const PlacedLabel& label : labels) {
    if (label.hasLeader) drawing.line(label.leaderFrom, label.leaderTo, {theme.frame, 1.0});
  }
  for (std::size_t i = 0; i < shown.size(); ++i)
    drawMarker(drawing, places[i].at, shown[i]->marker, kRim, theme.ground);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (shown[i]->label.empty()) continue;
    TextStyle style = theme.label;
    style.color = shown[i]->marker.color;
    drawing.add(Text{labels[i].at, shown[i]->label, style, labels[i].anchor});
  }
}

void drawCursor(Drawing& drawing, const Panel& panel, const PanelLayout& layout,
                const PlotTheme& theme, const TextMetrics& metrics) {
  constexpr double cornerRadius = 4.0;
  const Box& area = layout.area;
  const double at = layout.x.at(panel.cursor->value);
  if (!isIn(area, {at, area.top})) return;
  drawing.line({at, area.top}, {at, area.bottom}, {theme.muted, 1.0});
  const TickLabel label = cursorLabel(*panel.cursor, layout.x, area.bottom,
                                      {layout.left, layout.right}, theme, metrics);
  drawing.add(Rectangle{label.box, theme.ground, {theme.frame, 1.0}, cornerRadius});
  TextStyle style = theme.tick;
  style.color = theme.ink;
  drawTickWords(drawing, label, style, metrics);
}

}  // namespace

void drawContents(Drawing& drawing, const Panel& panel, const PanelLayout& layout,
                  const PlotTheme& theme, const TextMetrics& metrics) {
  drawTitle(drawing, {panel.title, panel.isSmall ? theme.tick : theme.title, panel.legend},
            {layout.area.left, layout.titleTop}, layout.area.width(), theme, metrics);
  if (!panel.message.empty()) {
    const Point middle = layout.area.centre();
    drawing.add(Text{{middle.x, middle.y + 0.36 * theme.label.size},
                     panel.message,
                     theme.label,
                     Anchor::middle});
    return;
  }
  for (const Ribbon& ribbon : panel.ribbons)
    drawRibbon(drawing, ribbon, layout);
  std::vector<Box> taken;
  for (const Level& level : panel.levels) {
    const auto more = drawLevel(drawing, level, layout, theme, metrics);
    taken.insert(taken.end(), more.begin(), more.end());
  }
  std::vector<LabelledPoint> obstacles;
  for (const Curve& curve : panel.curves)
    drawCurve(drawing, curve, layout, theme, obstacles);
  if (panel.cursor) drawCursor(drawing, panel, layout, theme, metrics);
  drawPoints(drawing, panel, layout, std::move(obstacles), taken, theme, metrics);
}

}  // namespace cutis
