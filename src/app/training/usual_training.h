#pragma once

#include <string>

#include "src/app/training/network_training.h"

namespace cutis {

// As the command train does it without further options, with the rig's own noise. `profile`: the
// name or path that the rig is to be fitted with, for the command that is recorded.
NetworkTraining usualTraining(const Rig& rig, const std::string& profile);

}  // namespace cutis
