#pragma once  // internal to core/neural

// What the trainings of both networks have in common, checked in one place.

#include <string>
#include <vector>

#include "core/neural/dense/trainer.h"
#include "core/neural/network_coordinates.h"

namespace cutis {

// One to eight hidden layers of 1 to kMaximumUnits units; hidden activations that bend; 1,000 to
// 10,000,000 people, a share of faces from 0 to 1; valid options of the trainer.
Status validateTraining(const std::vector<int>& hidden, Activation activation,
                        const TrainingPeople& people, const TrainerOptions& trainer,
                        const std::string& place);

// A fresh state gets the network to start from; one that went on must have a network of its shape.
Status beginTraining(const DenseNetwork& fresh, const std::string& place, TrainingState& state);

// Exponents of 1 to 3, positive maxima, at least two samples.
Status validateAxes(const ParameterAxes& axes, const std::string& place);

}  // namespace cutis
