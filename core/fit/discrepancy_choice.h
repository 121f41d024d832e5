#pragma once

// Which discrepancy of the model's profile a fit estimates beside the parameters; null for none.
// Thread-safe: a pure function; the result lives as long as the profile.

#include "core/fit/fit_options.h"
#include "core/rig/measurements.h"
#include "core/rig/rig.h"
#include "core/skin/profile/profile.h"

namespace cutis {

// That of options.surface, for the refined fit without free constants; null where the profile does
// not know it, where options.discrepancy says no, and in the exact setting unless it says yes.
const Discrepancy* chosenDiscrepancy(const Profile& profile, const Rig& rig,
                                     const FitOptions& options);

// What a refined fit assumes of the parameters beforehand: the options' prior, or that of the
// chosen discrepancy, or the profile's.
Prior assumedPrior(const Profile& profile, const Rig& rig, const FitOptions& options);

// The options for these measurements: simulated ones are of the model's own skin, of which nothing
// is left over, unless the options say otherwise.
FitOptions suitedTo(const Measurements& measurements, FitOptions options);

}  // namespace cutis
