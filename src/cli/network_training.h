#pragma once

// Training of both networks for a rig and a profile, and how well they turned out.
//
// Thread-safe; uses all cores it may. Deterministic by options (on one instruction set). Cancelled
// if asked to stop.

#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/skin/skin_model.h"
#include "src/files/network_file.h"

namespace cutis {

struct NetworkTraining {
  SpectraNetworkOptions spectra;
  ChromophoreNetworkOptions chromophores;
  int tableStep = 1;    // every how many entries of the table the components are taken from, ≥ 1
  std::string command;  // to be recorded
};

struct TrainedNetworks {
  NetworkFile file;  // as it reads back
  int components = 0;
  double truncationError = 0.0;  // mean squared error of reflectance, 300–1000 nm, over the table
  double seconds = 0.0;
};

// Errors: those of trainSpectraNetwork() and trainChromophoreNetwork(). Cost with the defaults:
// under a minute on two cores.
Result<TrainedNetworks> trainNetworks(const SkinModel& model, const Rig& rig,
                                      const NetworkTraining& training, const JobContext& context);

// Mean squared errors of reflectance, 400–700 nm, against SkinModel in double precision, over
// people of protocolPopulation().
struct NetworkErrors {
  double decoded = 0.0;  // parameters → SpectraNN
  double encoded = 0.0;  // channels → ChromNN → SkinModel: the error of fit --method network
  double both = 0.0;     // channels → ChromNN → SpectraNN
  double encodedNoisy = 0.0;  // the same two, of channels with the rig's noise
  double bothNoisy = 0.0;
};

Result<NetworkErrors> measureNetworks(const SkinModel& model, const Rig& rig,
                                      const NetworkFile& file, const JobContext& context);

}  // namespace cutis
