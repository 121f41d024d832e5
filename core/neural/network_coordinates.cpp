#include "core/neural/network_coordinates.h"

#include <cstddef>

#include "core/base/random.h"

namespace cutis {
namespace {

// The error protocol's box.
const ParameterVector kFaceLow = {0.01, 0.2, 0.005, 0.0, 0.0};
const ParameterVector kFaceHigh = {0.25, 1.0, 0.1, 0.05, 0.004};
constexpr double kFaceMargin = 0.08;

}  // namespace

double networkCoordinate(const ParameterAxis& axis, double value) {
  return axis.index(value) / (axis.samples - 1);
}

double parameterOfCoordinate(const ParameterAxis& axis, double coordinate) {
  return axis.value(coordinate * (axis.samples - 1));
}

std::vector<ParameterVector> drawTrainingPeople(const TrainingPeople& people,
                                                const ParameterAxes& axes) {
  std::vector<ParameterVector> result(static_cast<std::size_t>(people.count));
  const ParameterVector margin = kFaceMargin * (kFaceHigh - kFaceLow);
  for (std::size_t i = 0; i < result.size(); ++i) {
    Random random(people.seed, i);
    const bool isFace = random.uniform() < people.faceShare;
    for (int k = 0; k < kParameterCount; ++k) {
      const ParameterAxis& axis = axes[static_cast<std::size_t>(k)];
      const double turn = random.uniform();
      const double low = kFaceLow[k] - margin[k];
      const double high = kFaceHigh[k] + margin[k];
      result[i][k] =
          isFace ? axis.clamp(low + turn * (high - low)) : parameterOfCoordinate(axis, turn);
    }
  }
  return result;
}

}  // namespace cutis
