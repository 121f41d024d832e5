#pragma once

// Options of training networks, from the command line to what is trained.

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "core/base/result.h"
#include "core/rig/rig.h"
#include "src/app/engine.h"
#include "src/app/training/network_training.h"
#include "src/files/profiles/profile_file.h"

namespace cutis {

// The texts as they were given; empty: not given.
struct TrainOptions {
  std::string rig;
  std::string profile = kDefaultProfile;
  std::string lights;
  std::string channels;
  std::string preset;
  std::string noise;
  std::string hidden;
  std::string activation;
  std::string components;
  std::string people;
  std::string tableStep;
  std::string epochs;
  std::string patience;
  std::string rate;
  std::string weightDecay;
  std::string batch;
  std::string seed;
};

void addTrainOptions(CLI::App& command, TrainOptions& options);

// What to do where a fit lacks a network: "train one with cutis-cli train --rig … and give it with
// --weights".
NetworkAdvice networkAdvice();

// The rig with the lights asked for; `notice` hears what of its files was left out.
Result<Rig> trainedRig(const TrainOptions& options, const Notice& notice);

// Errors are usage errors in the option's name.
Result<NetworkTraining> trainingOf(const TrainOptions& options, const NoiseModel& rigNoise);

// "32,32" → hidden layers.
Result<std::vector<int>> hiddenLayers(const std::string& option, const std::string& text);

}  // namespace cutis
