#include "src/report/plot/panel_layout.h"

#include <algorithm>

#include "src/report/plot/tick_labels.h"
#include "src/report/plot/title_line.h"

namespace cutis {
namespace {

// Numbers across are centred at the ends of an axis, too, unless they would reach out farther.
constexpr double kFarthestReach = 15.0;

bool hasWords(const std::vector<Tick>& ticks) {
  return std::any_of(ticks.begin(), ticks.end(),
                     [](const Tick& tick) { return !tick.words.empty(); });
}

bool hasNamesAbove(const Panel& panel) {
  return hasWords(panel.above) ||
         std::any_of(panel.shades.begin(), panel.shades.end(),
                     [](const Shade& shade) { return !shade.name.empty(); });
}

bool hasTitle(const Axis& axis, const PlotTheme& theme) {
  return theme.hasAxisTitles && !axis.title.empty();
}

}  // namespace

Rooms sideRooms(const Panel& panel, const PlotTheme& theme, const TextMetrics& metrics) {
  Rooms rooms;
  for (const Tick& tick : writtenTicks(panel.y, theme)) {
    if (!tick.words.empty())
      rooms.left = std::max(rooms.left, theme.space + tickWidth(tick, theme.tick, metrics));
  }
  if (!panel.y.widest.empty()) {
    rooms.left = std::max(rooms.left, theme.space + metrics.width(panel.y.widest, theme.tick));
  }
  if (hasTitle(panel.y, theme)) rooms.left += theme.space + metrics.height(theme.label);
  rooms.right = theme.space;
  if (hasWords(panel.x.ticks)) {
    const auto reach = [&](const Tick& tick) {
      return std::min(0.5 * tickWidth(tick, theme.tick, metrics), kFarthestReach);
    };
    rooms.left = std::max(rooms.left, reach(panel.x.ticks.front()));
    rooms.right = std::max(theme.farSpace, theme.space + reach(panel.x.ticks.back()));
  }
  return rooms;
}

Rooms roomsAround(const Panel& panel, double areaWidth, const PlotTheme& theme,
                  const TextMetrics& metrics) {
  Rooms rooms = sideRooms(panel, theme, metrics);
  rooms.top = titleHeight({panel.title, panel.isSmall ? theme.tick : theme.title, panel.legend},
                          areaWidth, theme, metrics);
  if (rooms.top > 0.0) rooms.top += 0.5 * theme.space;
  if (hasNamesAbove(panel)) rooms.top += metrics.height(theme.tick) + 2.0;
  // The topmost number is centred at the upper edge.
  if (hasWords(panel.y.ticks)) rooms.top = std::max(rooms.top, 0.5 * metrics.height(theme.tick));
  if (hasWords(panel.x.ticks)) rooms.bottom += kTickLength + metrics.height(theme.tick);
  if (hasTitle(panel.x, theme)) rooms.bottom += 0.5 * theme.space + metrics.height(theme.label);
  return rooms;
}

PanelLayout layOut(const Panel& panel, const Box& area, const Rooms& sides, double titleTop,
                   const PlotTheme& theme) {
  return {area,
          titleTop,
          area.left - sides.left,
          area.right + sides.right - theme.space,
          usableScale(panel.x.from, panel.x.to, panel.x.logarithmic, area.left, area.right),
          usableScale(panel.y.from, panel.y.to, panel.y.logarithmic, area.bottom, area.top)};
}

PanelLayout layOut(const Panel& panel, const Box& outside, const PlotTheme& theme,
                   const TextMetrics& metrics) {
  const Rooms sides = sideRooms(panel, theme, metrics);
  const double width = std::max(outside.width() - sides.left - sides.right, 1.0);
  const Rooms rooms = roomsAround(panel, width, theme, metrics);
  Box area = {outside.left + rooms.left, outside.top + rooms.top, 0.0,
              outside.bottom - rooms.bottom};
  area.right = area.left + width;
  area.bottom = std::max(area.bottom, area.top + 1.0);
  return layOut(panel, area, sides, outside.top, theme);
}

}  // namespace cutis
