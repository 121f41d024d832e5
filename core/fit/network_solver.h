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

// Whether the network was trained for channels of this rig, all or the paper's five, and for this
// profile; rounding apart. Returns the channels it takes. `place` stands in front of the error,
// which says what it was trained for and leaves to the caller what to do.
Result<NetworkChannels> matchNetwork(const ChromophoreNetwork& network, const Profile& profile,
                                     const Rig& rig, const std::string& place);

// channels: those that matchNetwork() found; photographed: their rows. Precondition: the network
// passed validate().
// Thread-safe. A pixel for which the network's numbers overflow is noConvergence with zeros. Cost:
// some 50 ns per pixel and core with the built-in sizes.
std::unique_ptr<const PixelSolver> makeNetworkSolver(
    const ChromophoreNetwork& network, const NetworkChannels& channels,
    std::shared_ptr<const ResponseModel> photographed);

}  // namespace cutis
