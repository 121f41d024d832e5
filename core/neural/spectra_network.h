#pragma once

// SpectraNN (paper §6.1): from five parameters to the weights of the spectra's principal
// components.
//
// Belongs to a profile and to no rig. The paper's has relus, 5-64-64-64-10; ours has half as many
// units with round corners (Activation::squareplus), which describe smooth spectra better with a
// third of the multiplications, and enough components to leave less than the network's own error.
//
// Evaluated through core/neural/network_pipeline.h.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/neural/dense/trainer.h"
#include "core/neural/network_coordinates.h"
#include "core/neural/spectra_basis.h"
#include "core/spectra/signature.h"

namespace cutis {

struct SpectraNetwork {
  Signature profile;   // of the profile it was trained for
  ParameterAxes axes;  // of that profile: they define the inputs
  Spectrum mean = Spectrum::Zero();
  Eigen::MatrixXd components;  // kSampleCount × outputs
  DenseNetwork network;  // networkCoordinate() of each parameter → weights of the components
};

// Shapes, finite numbers, usable axes.
Status validate(const SpectraNetwork& network, const std::string& place);

struct SpectraNetworkOptions {
  std::vector<int> hidden = {32, 32, 32};
  Activation activation = Activation::squareplus;
  int components = 0;  // 0: as few as leave truncationError
  double truncationError = 1e-8;
  TrainingPeople people;
  TrainerOptions trainer = {.rate = 0.02, .weightDecay = 0.0, .epochs = 50};

  bool operator==(const SpectraNetworkOptions&) const = default;
};

// The paper's network: relu 64-64-64, 10 components, rate and weight decay of §6.1. At that rate it
// takes many more epochs than ours for the same error.
SpectraNetworkOptions paperSpectraNetworkOptions();

// Trained on the mean squared error of whole spectra, 300–1000 nm; the errors on the curve are in
// that unit, without what truncation adds. A fresh `state` starts anew; one that an earlier call
// with the same arguments left behind, when it was cancelled, goes on. Errors: options out of
// range, those of trainNetwork(). Cost with the defaults: about 15 s on two cores.
Result<SpectraNetwork> trainSpectraNetwork(const SkinModel& model, const SpectraBasis& basis,
                                           const SpectraNetworkOptions& options,
                                           TrainingState& state, const JobContext& context,
                                           const EpochCallback& onEpoch = {});

}  // namespace cutis
