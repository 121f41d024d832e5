#include "core/neural/dense/adam.h"

#include <cmath>

namespace cutis {
namespace {

constexpr double kFirstDecay = 0.9;
constexpr double kSecondDecay = 0.999;
// Gradients of spectral errors are small: the usual 1e-8 would stand above them.
constexpr float kEpsilon = 1e-12f;

}  // namespace

void adamUpdate(const AdamStep& step, const float* gradient, std::size_t count, float* firstMoment,
                float* secondMoment, float* weights) {
  const auto n = static_cast<double>(step.step);
  const auto rate = static_cast<float>(step.rate / (1.0 - std::pow(kFirstDecay, n)));
  const auto correction = static_cast<float>(1.0 / (1.0 - std::pow(kSecondDecay, n)));
  const auto kept = static_cast<float>(1.0 - step.rate * step.weightDecay);
  constexpr auto firstDecay = static_cast<float>(kFirstDecay);
  constexpr auto secondDecay = static_cast<float>(kSecondDecay);
  for (std::size_t i = 0; i < count; ++i) {
    const float g = gradient[i];
    const float first = firstDecay * firstMoment[i] + (1.0f - firstDecay) * g;
    const float second = secondDecay * secondMoment[i] + (1.0f - secondDecay) * g * g;
    firstMoment[i] = first;
    secondMoment[i] = second;
    weights[i] = kept * weights[i] - rate * first / (std::sqrt(second * correction) + kEpsilon);
  }
}

}  // namespace cutis
