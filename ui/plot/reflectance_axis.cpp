#include "ui/plot/reflectance_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "src/report/plot/ticks.h"

namespace cutis {
namespace {

constexpr double kHeadroom = 1.03;
constexpr int kAxisSteps = 5;
// From a perfect diffuser's hundredth to a glossy one.
constexpr std::array kTidy = {0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1, 0.15, 0.2, 0.25,
                              0.3,  0.4,  0.5,  0.6,  0.7,  0.8,  0.9,  1.0, 1.2,  1.5};

}  // namespace

double ReflectanceAxis::maximum() const {
  if (chosen_) return *chosen_;
  return seen_ > 0.0 ? niceCeiling(kHeadroom * seen_, kAxisSteps) : 1.0;
}

void ReflectanceAxis::see(double value) {
  if (std::isfinite(value)) seen_ = std::max(seen_, value);
}

void ReflectanceAxis::step(int count) {
  constexpr double slack = 1e-9;
  const double now = maximum();
  // The number itself, or the next one in the direction of the step.
  auto at = count > 0 ? std::upper_bound(kTidy.begin(), kTidy.end(), now + slack) - 1
                      : std::lower_bound(kTidy.begin(), kTidy.end(), now - slack);
  const auto last = static_cast<std::ptrdiff_t>(kTidy.size()) - 1;
  const auto index = std::clamp<std::ptrdiff_t>((at - kTidy.begin()) + count, 0, last);
  chosen_ = kTidy[static_cast<std::size_t>(index)];
}

void ReflectanceAxis::forget() {
  seen_ = 0.0;
  chosen_.reset();
}

}  // namespace cutis
