#include "src/report/plot/tick_labels.h"

#include <algorithm>
#include <cmath>

namespace cutis {
namespace {

constexpr double kRaisedSize = 0.74, kRise = 0.42;  // of the number's size
constexpr double kRaisedGap = 0.5;
constexpr double kDigitMiddle = 0.36;  // of digits above their baseline
constexpr double kClear = 6.0;         // between neighbours across
constexpr double kLineSpacing = 1.3;   // between neighbours upwards, in heights
constexpr double kCursorMargin = 4.0;
constexpr double kSlack = 1e-9;

TextStyle raisedStyle(const TextStyle& style) {
  TextStyle raised = style;
  raised.size *= kRaisedSize;
  return raised;
}

bool isWithin(double value, double from, double to) {
  const double slack = kSlack * std::abs(to - from);
  return from - slack <= value && value <= to + slack;
}

TickLabel centred(const Tick& tick, double x, double top, const Reach& reach, double margin,
                  const TextStyle& style, const TextMetrics& metrics) {
  const double half = 0.5 * tickWidth(tick, style, metrics) + margin;
  const double middle = std::max(std::min(x, reach.right - half), reach.left + half);
  return {tick,
          {middle, top + metrics.ascent(style)},
          Anchor::middle,
          {middle - half, top, middle + half, top + metrics.height(style)}};
}

bool touches(const TickLabel& a, const TickLabel& b) {
  return a.box.left - kClear < b.box.right && b.box.left - kClear < a.box.right &&
         a.box.top < b.box.bottom && b.box.top < a.box.bottom;
}

bool anyTouch(const std::vector<TickLabel>& labels) {
  for (std::size_t i = 1; i < labels.size(); ++i) {
    if (touches(labels[i - 1], labels[i])) return true;
  }
  return false;
}

std::vector<TickLabel> everySome(const std::vector<TickLabel>& labels, std::size_t step) {
  std::vector<TickLabel> some;
  for (std::size_t i = 0; i < labels.size(); i += step)
    some.push_back(labels[i]);
  return some;
}

// All if they fit, else the major ones, else every second or further of these.
std::vector<TickLabel> thinned(std::vector<TickLabel> labels) {
  if (!anyTouch(labels)) return labels;
  std::erase_if(labels, [](const TickLabel& label) { return label.tick.minor; });
  for (std::size_t step = 1; step < labels.size(); ++step) {
    auto some = everySome(labels, step);
    if (!anyTouch(some)) return some;
  }
  return everySome(labels, std::max<std::size_t>(labels.size(), 1));
}

}  // namespace

double tickWidth(const Tick& tick, const TextStyle& style, const TextMetrics& metrics) {
  const double width = metrics.width(tick.words, style);
  if (tick.raised.empty()) return width;
  return width + kRaisedGap + metrics.width(tick.raised, raisedStyle(style));
}

std::vector<Tick> writtenTicks(const Axis& axis, const PlotTheme& theme) {
  std::vector<Tick> ticks;
  for (const Tick& tick : axis.ticks) {
    if (isWithin(tick.value, axis.from, axis.to)) ticks.push_back(tick);
  }
  if (!theme.hasAxisTitles && !axis.unit.empty() && !ticks.empty())
    ticks.back().words += " " + axis.unit;
  return ticks;
}

std::vector<TickLabel> labelsAcross(const Axis& axis, const Scale& scale,
                                    const std::optional<Tick>& cursor, double axisY,
                                    const Reach& reach, const PlotTheme& theme,
                                    const TextMetrics& metrics) {
  std::vector<TickLabel> labels;
  for (const Tick& tick : writtenTicks(axis, theme)) {
    labels.push_back(
        centred(tick, scale.at(tick.value), axisY + kTickLength, reach, 0.0, theme.tick, metrics));
  }
  // The one with the unit goes before its neighbours.
  std::vector<TickLabel> kept;
  if (!theme.hasAxisTitles && !axis.unit.empty() && !labels.empty()) {
    kept.push_back(labels.back());
    labels.pop_back();
    std::erase_if(labels, [&](const TickLabel& label) { return touches(label, kept[0]); });
  }
  labels = thinned(std::move(labels));
  labels.insert(labels.end(), kept.begin(), kept.end());
  if (cursor) {
    const TickLabel own = cursorLabel(*cursor, scale, axisY, reach, theme, metrics);
    std::erase_if(labels, [&](const TickLabel& label) { return label.box.overlaps(own.box); });
  }
  return labels;
}

TickLabel cursorLabel(const Tick& cursor, const Scale& scale, double axisY, const Reach& reach,
                      const PlotTheme& theme, const TextMetrics& metrics) {
  return centred(cursor, scale.at(cursor.value), axisY + kTickLength, reach, kCursorMargin,
                 theme.tick, metrics);
}

std::vector<TickLabel> labelsAbove(const std::vector<Tick>& ticks, const Scale& scale, double axisY,
                                   const PlotTheme& theme, const TextMetrics& metrics) {
  std::vector<TickLabel> labels;
  for (const Tick& tick : ticks) {
    if (!isWithin(tick.value, scale.from, scale.to)) continue;
    labels.push_back(centred(tick, scale.at(tick.value), axisY - metrics.height(theme.tick),
                             {scale.begin, scale.end}, 0.0, theme.tick, metrics));
  }
  return thinned(std::move(labels));
}

std::vector<TickLabel> labelsUpwards(const Axis& axis, const Scale& scale, double axisX,
                                     const PlotTheme& theme, const TextMetrics& metrics) {
  const double right = axisX - theme.space;
  const double half = kLineSpacing * 0.5 * metrics.height(theme.tick);
  std::vector<TickLabel> labels;
  for (const Tick& tick : writtenTicks(axis, theme)) {
    const double y = scale.at(tick.value);
    labels.push_back({tick,
                      {right, y + kDigitMiddle * theme.tick.size},
                      Anchor::end,
                      {right - tickWidth(tick, theme.tick, metrics), y - half, right, y + half}});
  }
  return thinned(std::move(labels));
}

void drawTickWords(Drawing& drawing, const TickLabel& label, const TextStyle& style,
                   const TextMetrics& metrics) {
  if (label.tick.raised.empty()) {
    if (!label.tick.words.empty())
      drawing.add(Text{label.at, label.tick.words, style, label.anchor});
    return;
  }
  const TextStyle raised = raisedStyle(style);
  const double after = kRaisedGap + metrics.width(label.tick.raised, raised);
  const double before = metrics.width(label.tick.words, style);
  double meet = label.at.x - after;
  if (label.anchor == Anchor::middle) meet = label.at.x + 0.5 * (before - after);
  if (label.anchor == Anchor::start) meet = label.at.x + before;
  drawing.add(Text{{meet, label.at.y}, label.tick.words, style, Anchor::end});
  drawing.add(Text{{meet + kRaisedGap, label.at.y - kRise * style.size},
                   label.tick.raised,
                   raised,
                   Anchor::start});
}

}  // namespace cutis
