#pragma once  // internal to src/cli/commands/train

// What train prints of networks it has trained.

#include <string>

#include "src/app/training/network_errors.h"
#include "src/app/training/network_training.h"

namespace cutis {

// Sizes and time; what is left of the spectra by the number of components; errors.
std::string trainReport(const TrainedNetworks& trained, const NetworkErrors& errors);

}  // namespace cutis
