#include "src/report/plot/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cutis {
namespace {

constexpr double kLabelAscent = 0.80, kDescent = 0.24;  // of the font's size
constexpr double kGap = 4.0;                            // between marker and label
constexpr double kLabelClear = 2.0;                     // around everything
constexpr double kLeaderFrom = 14.0;                    // nearer than this needs no line
constexpr double kOverlapCost = 1000.0;
constexpr int kPasses = 6;

// Ways to go from the marker, in order of preference.
constexpr std::array<Point, 12> kDirections = {{{1, 0},
                                                {-1, 0},
                                                {0, -1},
                                                {0, 1},
                                                {0.8, -0.6},
                                                {0.8, 0.6},
                                                {-0.8, -0.6},
                                                {-0.8, 0.6},
                                                {0.45, -0.9},
                                                {0.45, 0.9},
                                                {-0.45, -0.9},
                                                {-0.45, 0.9}}};
constexpr std::array<double, 8> kDistances = {0.0, 6.0, 14.0, 22.0, 32.0, 44.0, 58.0, 76.0};

Box around(Point centre, double reach) {
  return {centre.x - reach, centre.y - reach, centre.x + reach, centre.y + reach};
}

bool lineMeets(Point from, Point to, const Box& box) {
  constexpr int steps = 40;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Point p = {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
    if (p.x > box.left && p.x < box.right && p.y > box.top && p.y < box.bottom) return true;
  }
  return false;
}

struct Candidate {
  PlacedLabel label;
  double cost = 0.0;
};

Candidate candidateAt(const LabelledPoint& point, Point way, double distance, double width,
                      double size) {
  const double reach = point.radius + kGap + distance;
  const Point end = {point.at.x + reach * way.x, point.at.y + reach * way.y};
  Candidate candidate;
  PlacedLabel& label = candidate.label;
  const double height = (kLabelAscent + kDescent) * size;
  label.anchor = way.x > 0.1 ? Anchor::start : way.x < -0.1 ? Anchor::end : Anchor::middle;
  // Beside, above or below the end of the way.
  const double middle = end.y + 0.5 * height * (way.y < -0.5 ? -1.0 : way.y > 0.5 ? 1.0 : 0.0);
  label.at = {end.x, middle + 0.5 * (kLabelAscent - kDescent) * size};
  double left = end.x;
  if (label.anchor == Anchor::middle) left -= 0.5 * width;
  if (label.anchor == Anchor::end) left -= width;
  label.box = {left - kLabelClear, middle - 0.5 * height, left + width + kLabelClear,
               middle + 0.5 * height};
  label.hasLeader = distance >= kLeaderFrom;
  label.leaderFrom = {point.at.x + (point.radius + 1.5) * way.x,
                      point.at.y + (point.radius + 1.5) * way.y};
  label.leaderTo = {end.x - 2.0 * way.x, end.y - 2.0 * way.y};
  candidate.cost = distance;
  return candidate;
}

// What is in the way of a label, the other labels as they are now among it.
double conflicts(const Candidate& candidate, std::size_t self,
                 std::span<const LabelledPoint> points, std::span<const PlacedLabel> placed,
                 std::span<const Box> taken, const Box& area) {
  const PlacedLabel& label = candidate.label;
  double cost = area.holds(label.box) ? 0.0 : 2.0 * kOverlapCost;
  for (const Box& box : taken) {
    if (box.overlaps(label.box)) cost += kOverlapCost;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Box marker = around(points[i].at, points[i].radius + kLabelClear);
    if (marker.overlaps(label.box)) cost += kOverlapCost;
    if (i == self) continue;
    // Markers on top of each other share their lines' beginnings.
    const bool together = std::abs(points[i].at.x - points[self].at.x) < points[i].radius &&
                          std::abs(points[i].at.y - points[self].at.y) < points[i].radius;
    if (label.hasLeader && !together && lineMeets(label.leaderFrom, label.leaderTo, marker))
      cost += 0.5 * kOverlapCost;
    if (i >= placed.size() || points[i].label.empty()) continue;
    const PlacedLabel& other = placed[i];
    if (other.box.overlaps(label.box)) cost += kOverlapCost;
    if (label.hasLeader && lineMeets(label.leaderFrom, label.leaderTo, other.box))
      cost += 0.5 * kOverlapCost;
    if (other.hasLeader && lineMeets(other.leaderFrom, other.leaderTo, label.box))
      cost += 0.5 * kOverlapCost;
  }
  return cost;
}

}  // namespace

std::vector<PlacedLabel> placeLabels(std::span<const LabelledPoint> points,
                                     std::span<const Box> taken, const Box& area,
                                     const TextStyle& style, const TextMetrics& metrics) {
  std::vector<double> widths;
  for (const LabelledPoint& point : points)
    widths.push_back(metrics.width(point.label, style));
  std::vector<PlacedLabel> placed;
  // The first pass looks at the labels before; the others put each where it is best among all.
  for (int pass = 0; pass < kPasses; ++pass) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      Candidate best;
      best.cost = std::numeric_limits<double>::infinity();
      if (points[i].label.empty()) best = {};
      for (std::size_t way = 0; way < kDirections.size() && !points[i].label.empty(); ++way) {
        for (const double distance : kDistances) {
          Candidate candidate =
              candidateAt(points[i], kDirections[way], distance, widths[i], style.size);
          candidate.cost +=
              1.5 * static_cast<double>(way) + conflicts(candidate, i, points, placed, taken, area);
          if (candidate.cost < best.cost) best = candidate;
        }
      }
      if (i < placed.size()) {
        placed[i] = best.label;
      } else {
        placed.push_back(best.label);
      }
    }
  }
  return placed;
}

}  // namespace cutis
