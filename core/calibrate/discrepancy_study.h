#pragma once

// What a profile's model leaves over of the spectra of some people
// (core/skin/profile/discrepancy.h), and what knowing it gains for people that were left out. All
// constants stay, and the profile's prior with them.
//
// Deterministic by the seed, for any number of threads. Thread-safe: pure functions.

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/calibrate/calibration_study.h"
#include "core/skin/profile/discrepancy.h"
#include "core/skin/profile/profile.h"

namespace cutis {

struct DiscrepancyStudy {
  Profile profile;
  StudiedSpectra spectra;  // aims are not used
  int components = 6;
};

// Both kinds: of the spectra as they are where the surface's reflection is included, and with that
// taken off; where it is not, it is added for the other kind. Aperture losses belong to neither.
//
// Errors: those of learnDiscrepancy() and of a layer table; cancelled if asked to stop. Two seconds
// for fifty people, and what a table takes. Precondition: spectra within the grid, at least two
// wavelengths.
Result<Discrepancies> learnDiscrepancies(const DiscrepancyStudy& study, const JobContext& context);

}  // namespace cutis
