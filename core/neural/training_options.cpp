#include "core/neural/training_options.h"

#include <cmath>

namespace cutis {

Status validateTraining(const std::vector<int>& hidden, Activation activation,
                        const TrainingPeople& people, const TrainerOptions& trainer,
                        const std::string& place) {
  if (hidden.empty() || hidden.size() > 8) {
    return inputError(
        place, "a network has one to eight hidden layers, not " + std::to_string(hidden.size()));
  }
  for (const int units : hidden) {
    if (units < 1 || units > kMaximumUnits) {
      return inputError(place, "a hidden layer has 1 to " + std::to_string(kMaximumUnits) +
                                   " units, not " + std::to_string(units));
    }
  }
  if (activation == Activation::linear) {
    return inputError(place,
                      "hidden layers need a nonlinear activation; use relu, sigmoid or "
                      "squareplus");
  }
  if (people.count < 1'000 || people.count > 10'000'000) {
    return inputError(place, "the number of people to train on must be from 1000 to 10000000");
  }
  if (!(people.faceShare >= 0.0 && people.faceShare <= 1.0)) {
    return inputError(place, "the share of faces must be from 0 to 1");
  }
  return validate(trainer, place);
}

Status beginTraining(const DenseNetwork& fresh, const std::string& place, TrainingState& state) {
  if (state.network.layers.empty()) state.network = fresh;
  if (sameShape(state.network, fresh)) return {};
  return inputError(place,
                    "the state of training belongs to another network; start again without it");
}

Status validateAxes(const ParameterAxes& axes, const std::string& place) {
  for (const ParameterAxis& axis : axes) {
    const bool usable = std::isfinite(axis.maximum) && axis.maximum > 0.0 && axis.samples >= 2 &&
                        axis.exponent >= 1 && axis.exponent <= 3;
    if (!usable) return inputError(place, "an axis of the parameters is not usable");
  }
  return {};
}

}  // namespace cutis
