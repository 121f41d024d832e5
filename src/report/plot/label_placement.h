#pragma once  // internal to src/report/plot

// Names for points of a plot, put where they cover neither points nor each other.

#include <span>
#include <string>
#include <vector>

#include "src/report/drawing.h"
#include "src/report/text_metrics.h"

namespace cutis {

struct LabelledPoint {
  Point at;
  double radius = 5.0;  // of its marker
  std::string label;    // empty: only to be kept clear of
};

struct PlacedLabel {
  Point at;  // baseline
  Anchor anchor = Anchor::start;
  Box box;
  // A line between marker and label, where they lie apart.
  bool hasLeader = false;
  Point leaderFrom, leaderTo;
};

// One place for each point, deterministic; labels stay inside `area` and clear of `taken`. Where
// there is no room for all, the least overlap is taken. Points must be finite.
std::vector<PlacedLabel> placeLabels(std::span<const LabelledPoint> points,
                                     std::span<const Box> taken, const Box& area,
                                     const TextStyle& style, const TextMetrics& metrics);

}  // namespace cutis
