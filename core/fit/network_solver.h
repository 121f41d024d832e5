#pragma once

// ChromNN (core/neural/chromophore_network.h) as a pixel solver: what the network answers, and
// nothing is refined. Channels outside of what it was trained on have an answer too, in the
// profile's box, which then says little.

#include <memory>

#include "core/base/result.h"
#include "core/fit/pixel_solver.h"
#include "core/neural/chromophore_network.h"
#include "core/rig/rig.h"

namespace cutis {

// Whether the network was trained for these channels of this profile. `place` stands in front of
// the error, which tells the command that trains one.
Status checkNetworkMatches(const ChromophoreNetwork& network, const Profile& profile,
                           const Rig& rig, const std::string& place);

// "cutis-cli train --rig … -o WEIGHTS.json", for messages.
std::string trainingCommand(const Profile& profile, const Rig& rig);

// channels: the rows of the rig. Preconditions: the network passed validate() and matches the rig.
// Thread-safe. A pixel for which the network's numbers overflow is noConvergence with zeros. Cost:
// some 50 ns per pixel and core with the built-in sizes.
std::unique_ptr<const PixelSolver> makeNetworkSolver(const ChromophoreNetwork& network,
                                                     std::shared_ptr<const ResponseModel> channels);

}  // namespace cutis
