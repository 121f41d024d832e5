#include "src/report/scale.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cutis {
namespace {

constexpr std::array<double, 3> kRound = {1.0, 2.0, 5.0};
constexpr double kMostSteps = 5.0;
// Beyond this many decades whole ones are enough.
constexpr double kFineDecades = 1.6;

}  // namespace

double Scale::at(double value) const {
  double share =
      logarithmic ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
  if (!(share >= 0.0)) share = 0.0;
  return begin + std::min(share, 1.0) * (end - begin);
}

std::vector<double> logarithmicTicks(double least, double most) {
  const bool fine = std::log10(most / least) < kFineDecades;
  const auto steps = fine ? kRound.size() : std::size_t{1};
  std::vector<double> ticks;
  const int first = static_cast<int>(std::floor(std::log10(least))) - 1;
  for (int decade = first;; ++decade) {
    for (std::size_t i = 0; i < steps; ++i) {
      const double tick = kRound[i] * std::pow(10.0, decade);
      // The last one at or below the least value begins the axis.
      if (tick <= least) ticks.clear();
      ticks.push_back(tick);
      if (tick >= most && ticks.size() > 1) return ticks;
    }
  }
}

std::vector<double> linearTicks(double most) {
  double step = std::pow(10.0, std::floor(std::log10(most / kMostSteps)));
  for (const double round : {1.0, 2.0, 5.0, 10.0}) {
    if (round * step * kMostSteps >= most) {
      step *= round;
      break;
    }
  }
  std::vector<double> ticks = {0.0};
  while (ticks.back() < most)
    ticks.push_back(step * static_cast<double>(ticks.size()));
  return ticks;
}

}  // namespace cutis
