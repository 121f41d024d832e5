#pragma once

// ChromNN (paper §6.1): from the channels of a rig to the five parameters, by sigmoids.
//
// What it is trained on is the spectrum, through a SpectraNN that stays as it is: the channels
// leave the parameters badly determined and the spectrum well, so an error of the parameters would
// make the network spend itself on what cannot be known. Inputs are logarithms of channels, turned
// into uncorrelated ones of variance 1.
//
// Evaluated through core/neural/network_pipeline.h.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/neural/network_channels.h"
#include "core/neural/spectra_network.h"

namespace cutis {

// Channels below count as this, in training and evaluation alike.
inline constexpr double kSmallestNetworkChannel = 1e-4;

struct ChromophoreNetwork {
  Signature profile;                // of the profile
  Signature channels;               // of the channels it was trained for
  std::vector<std::string> inputs;  // their names, for people
  ParameterAxes axes;               // they define the outputs
  DenseNetwork network;             // ln of each channel → networkCoordinate() of each parameter
};

// Shapes, a name for each input, finite numbers, usable axes, a sigmoid at the end.
Status validate(const ChromophoreNetwork& network, const std::string& place);

struct ChromophoreNetworkOptions {
  std::vector<int> hidden = {32, 32};
  Activation activation = Activation::squareplus;
  // The noise of the photographs that are learned from. Each person has a share of it, drawn evenly
  // from 0 to 1. Without any noise the network becomes up to ten times as accurate on noiseless
  // channels and useless on all others.
  NoiseModel noise;
  TrainingPeople people = {.seed = 11};
  TrainerOptions trainer = {.rate = 0.02, .weightDecay = 0.0, .epochs = 40};
};

// Sigmoids in the hidden layers, rate and weight decay of the paper, no noise.
ChromophoreNetworkOptions paperChromophoreNetworkOptions();

// The errors on the curve are mean squared errors of reflectance, 300–1000 nm, of what was trained
// on, noise included. state: as for trainSpectraNetwork(). Errors: a SpectraNN of another profile,
// options out of range, no channels or more than kMaximumUnits, those of trainNetwork(). Cost with
// the defaults: about 20 s on two cores.
Result<ChromophoreNetwork> trainChromophoreNetwork(const SkinModel& model,
                                                   const NetworkChannels& channels,
                                                   const SpectraNetwork& spectra,
                                                   const ChromophoreNetworkOptions& options,
                                                   TrainingState& state, const JobContext& context,
                                                   const EpochCallback& onEpoch = {});

}  // namespace cutis
