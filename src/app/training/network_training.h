#pragma once

// Training of both networks for a rig and a profile: principal components, SpectraNN, ChromNN.
//
// Thread-safe; uses all cores it may. Deterministic by options (on one instruction set), also where
// it was cancelled and taken up again. Cancelled if asked to stop.

#include <functional>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/neural/spectra_basis.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "src/files/networks/network_file.h"
#include "src/files/networks/training_file.h"

namespace cutis {

struct NetworkTraining {
  SpectraNetworkOptions spectra;
  ChromophoreNetworkOptions chromophores;
  bool paperChannels = false;  // r, g, b, sb, sg instead of all channels of the rig
  int tableStep = 1;    // every how many entries of the table the components are taken from, ≥ 1
  std::string command;  // to be recorded
};

// As the command train does it without further options, with the rig's own noise. `profile`: the
// name or path that the rig is to be fitted with, for the command that is recorded.
NetworkTraining usualTraining(const Rig& rig, const std::string& profile);

enum class NetworkKind { spectra, chromophores };
// "SpectraNN" or "ChromNN".
const char* networkName(NetworkKind kind);

struct NetworkEpoch {
  NetworkKind network = NetworkKind::spectra;
  int epochs = 1;  // that this network is trained for, at most
  TrainingEpoch epoch;
};
// Called after each epoch, from the thread that trains; first all of SpectraNN, then all of
// ChromNN. The state given to trainNetworks() is then that after this epoch and may be copied.
using NetworkObserver = std::function<void(const NetworkEpoch&)>;

struct TrainedNetworks {
  NetworkFile file;                         // as it reads back
  SpectraBasis basis;                       // of which the networks use the first few components
  std::vector<TrainingEpoch> spectraCurve;  // errors: those of the two trainings, core/neural
  std::vector<TrainingEpoch> chromophoreCurve;
  double seconds = 0.0;  // of this call

  int components() const { return static_cast<int>(file.spectra.components.cols()); }
};

// The identity of everything that changes the result, for TrainingFile. Fails as trainNetworks()
// does where the rig lacks channels.
Result<std::string> trainingIdentity(const SkinModel& model, const Rig& rig,
                                     const NetworkTraining& training);

// A fresh state starts anew; one that a cancelled call with the same arguments left behind goes on.
// Errors: those of trainSpectraNetwork() and trainChromophoreNetwork(); a rig without the paper's
// channels where they are asked for. Cost with the defaults:
// under a minute on two cores.
Result<TrainedNetworks> trainNetworks(const SkinModel& model, const Rig& rig,
                                      const NetworkTraining& training, NetworkTrainingState& state,
                                      const JobContext& context,
                                      const NetworkObserver& observer = {});

}  // namespace cutis
