#pragma once  // internal to src/report/plot

// The numbers beside an axis: how large they are, where they stand, and which are left out where
// there is no room for all.

#include <optional>
#include <vector>

#include "src/report/plot/axis.h"
#include "src/report/plot/scale.h"
#include "src/report/plot/theme.h"
#include "src/report/text_metrics.h"

namespace cutis {

struct TickLabel {
  Tick tick;
  Point at;  // of the baseline; the words are centred below an axis, and end at one upwards
  Anchor anchor = Anchor::middle;
  Box box;
};

inline constexpr double kTickLength = 4.0;

// The width of the words and of what is raised after them.
double tickWidth(const Tick& tick, const TextStyle& style, const TextMetrics& metrics);

// Ticks between the ends of an axis, the last one with the unit if the theme wants it there.
std::vector<Tick> writtenTicks(const Axis& axis, const PlotTheme& theme);

// From where to where numbers may reach.
struct Reach {
  double left = 0.0, right = 0.0;
};

// Numbers below an axis across. Those that touch the cursor's, which has a margin, are left out.
std::vector<TickLabel> labelsAcross(const Axis& axis, const Scale& scale,
                                    const std::optional<Tick>& cursor, double axisY,
                                    const Reach& reach, const PlotTheme& theme,
                                    const TextMetrics& metrics);
// The cursor's own.
TickLabel cursorLabel(const Tick& cursor, const Scale& scale, double axisY, const Reach& reach,
                      const PlotTheme& theme, const TextMetrics& metrics);
// Numbers on the upper side.
std::vector<TickLabel> labelsAbove(const std::vector<Tick>& ticks, const Scale& scale, double axisY,
                                   const PlotTheme& theme, const TextMetrics& metrics);
// Numbers left of an axis upwards.
std::vector<TickLabel> labelsUpwards(const Axis& axis, const Scale& scale, double axisX,
                                     const PlotTheme& theme, const TextMetrics& metrics);

// Adds the words. The number and its exponent meet in one place, whatever font the viewer has.
void drawTickWords(Drawing& drawing, const TickLabel& label, const TextStyle& style,
                   const TextMetrics& metrics);

}  // namespace cutis
