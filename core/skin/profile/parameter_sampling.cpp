#include "core/skin/profile/parameter_sampling.h"

#include <cmath>
#include <cstddef>

namespace cutis {
namespace {

// The positive root of x^6 = x + 1: the generalised golden ratio of five dimensions.
constexpr double kRatio = 1.1673039782614187;
static_assert(kParameterCount == 5, "the root of x^(n + 1) = x + 1 for n parameters");
// The fractions of √2 and √3.
constexpr double kTurns[] = {0.41421356237309515, 0.7320508075688772};

}  // namespace

std::vector<ParameterVector> sampleBox(const ParameterAxes& axes, int count, int first) {
  std::vector<ParameterVector> points(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    double step = 1.0;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      step /= kRatio;
      const double turn = 0.5 + step * (first + i + 1);
      const double index = (turn - std::floor(turn)) * (axes[k].samples - 1);
      points[static_cast<std::size_t>(i)][static_cast<Eigen::Index>(k)] = axes[k].value(index);
    }
  }
  return points;
}

double samplePlace(int which, int point) {
  const double turn = kTurns[which] * static_cast<double>(point + 1);
  return turn - std::floor(turn);
}

}  // namespace cutis
