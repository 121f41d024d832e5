#include <algorithm>

#include "src/report/plot/panel_drawing.h"
#include "src/report/plot/tick_labels.h"

namespace cutis {
namespace {

void drawShades(Drawing& drawing, const Panel& panel, const PanelLayout& layout,
                const PlotTheme& theme, const TextMetrics& metrics) {
  const double nameHeight = metrics.height(theme.tick) + 2.0;
  for (const Shade& shade : panel.shades) {
    const auto place = [&](double value) {
      return std::clamp(layout.x.at(value), layout.area.left, layout.area.right);
    };
    const double left = place(shade.from), right = place(shade.to);
    if (!(right > left)) continue;
    const double top = layout.area.top - (shade.name.empty() ? 0.0 : nameHeight);
    drawing.add(Rectangle{{left, top, right, layout.area.bottom}, shade.color, kNoStroke, 0.0});
    const std::string name = shortened(shade.name, theme.tick, right - left, metrics);
    if (name.empty() || metrics.width(name, theme.tick) > right - left) continue;
    drawing.add(Text{{0.5 * (left + right), top + 1.0 + metrics.ascent(theme.tick)},
                     name,
                     theme.tick,
                     Anchor::middle});
  }
}

bool isInside(double place, double begin, double end) {
  constexpr double slack = 1e-6;
  return std::min(begin, end) - slack <= place && place <= std::max(begin, end) + slack;
}

void drawAcross(Drawing& drawing, const Panel& panel, const PanelLayout& layout,
                const PlotTheme& theme, const TextMetrics& metrics) {
  const Box& area = layout.area;
  const Stroke axis = {theme.frame, 1.0};
  for (const Tick& tick : panel.x.ticks) {
    const double at = layout.x.at(tick.value);
    if (!isInside(at, area.left, area.right)) continue;
    if (panel.x.hasGrid) drawing.line({at, area.top}, {at, area.bottom}, {theme.grid, 1.0});
    if (!tick.words.empty()) drawing.line({at, area.bottom}, {at, area.bottom + kTickLength}, axis);
  }
  for (const TickLabel& label : labelsAcross(panel.x, layout.x, panel.cursor, area.bottom,
                                             {layout.left, layout.right}, theme, metrics))
    drawTickWords(drawing, label, theme.tick, metrics);
  for (const TickLabel& label : labelsAbove(panel.above, layout.x, area.top, theme, metrics)) {
    const double at = layout.x.at(label.tick.value);
    drawing.line({at, area.top}, {at, area.top + kTickLength}, axis);
    drawTickWords(drawing, label, theme.tick, metrics);
  }
}

void drawUpwards(Drawing& drawing, const Panel& panel, const PanelLayout& layout,
                 const PlotTheme& theme, const TextMetrics& metrics) {
  const Box& area = layout.area;
  const auto labels = labelsUpwards(panel.y, layout.y, area.left, theme, metrics);
  const auto isWritten = [&](const Tick& tick) {
    return std::any_of(labels.begin(), labels.end(),
                       [&](const TickLabel& label) { return label.tick.value == tick.value; });
  };
  for (const Tick& tick : panel.y.ticks) {
    const double at = layout.y.at(tick.value);
    const bool isZero = !panel.y.logarithmic && tick.value == 0.0;
    if (!isInside(at, area.top, area.bottom) || !(panel.y.hasGrid || isZero)) continue;
    // Where minor numbers have no room, their lines would only be many.
    if (tick.minor && !isWritten(tick)) continue;
    drawing.line({area.left, at}, {area.right, at}, {isZero ? theme.frame : theme.grid, 1.0});
  }
  for (const TickLabel& label : labels)
    drawTickWords(drawing, label, theme.tick, metrics);
}

std::string titleOf(const Axis& axis) {
  return axis.unit.empty() ? axis.title : axis.title + ", " + axis.unit;
}

void drawAxisTitles(Drawing& drawing, const Panel& panel, const PanelLayout& layout,
                    const PlotTheme& theme, const TextMetrics& metrics) {
  const Box& area = layout.area;
  if (!panel.x.title.empty()) {
    const double top = area.bottom + kTickLength + metrics.height(theme.tick) + 0.5 * theme.space;
    drawing.add(Text{{area.centre().x, top + metrics.ascent(theme.label)},
                     titleOf(panel.x),
                     theme.label,
                     Anchor::middle});
  }
  if (!panel.y.title.empty()) {
    const double left = area.left - sideRooms(panel, theme, metrics).left;
    drawing.add(Text{{left + metrics.ascent(theme.label), area.centre().y},
                     shortened(titleOf(panel.y), theme.label, area.height(), metrics),
                     theme.label,
                     Anchor::middle,
                     true});
  }
}

}  // namespace

void drawFrame(Drawing& drawing, const Panel& panel, const PanelLayout& layout,
               const PlotTheme& theme, const TextMetrics& metrics) {
  drawShades(drawing, panel, layout, theme, metrics);
  if (panel.message.empty()) drawUpwards(drawing, panel, layout, theme, metrics);
  drawAcross(drawing, panel, layout, theme, metrics);
  if (theme.isFramed) drawing.add(Rectangle{layout.area, kNoColor, {theme.frame, 1.0}, 0.0});
  if (theme.hasAxisTitles) drawAxisTitles(drawing, panel, layout, theme, metrics);
}

}  // namespace cutis
