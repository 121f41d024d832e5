#pragma once

// What a refined fit takes for granted of the channels: which of them see something, how noisy
// they are, and how exactly their sums at spectral nodes must hold.
//
// Thread-safe: pure functions.

#include "core/fit/fit_options.h"
#include "core/rig/rig.h"

namespace cutis {

// The least noise that is assumed, a standard deviation of a channel: stands in for "none" where
// none is asked for, and for read noise in channels that are all but black, whose proportional
// noise would be nothing. A sixteenth of what a 16-bit image resolves, and not less, because a
// float carries seven digits: below, the pass in float would follow its own rounding.
inline constexpr double kExactNoise = 1e-6;

// Whether no noise is to be assumed (the exact setting).
bool asksForExact(const Rig& rig, const FitOptions& options);

// Values to find: parameters that are not held, and free constants.
int unknownCount(const FitOptions& options);
// Channels that see something.
int seeingChannelCount(const Rig& rig);
// How many of these are no mixture of the others: a grey camera has one for each light.
int independentChannelCount(const Rig& rig);

// The options' noise or the rig's; never none, which stands for the least there is.
NoiseModel assumedNoise(const Rig& rig, const FitOptions& options);

// Root mean square error of a channel.
double nodeTolerance(const Rig& rig, const FitOptions& options);

}  // namespace cutis
