#pragma once

// What a profile's model leaves over of the spectra of some people
// (core/skin/profile/discrepancy.h), and what knowing it gains for people that were left out. All
// constants stay, and the profile's prior with them.
//
// Errors of reflectance are root mean squares over the wavelengths of one spectrum. Deterministic
// by the seed, for any number of threads. Thread-safe: pure functions.

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/calibrate/calibration_study.h"
#include "core/rig/rig.h"
#include "core/skin/profile/discrepancy.h"
#include "core/skin/profile/profile.h"

namespace cutis {

// What a left-out person's spectrum is estimated from.
struct JudgedChannels {
  Rig rig;
  double noise = 0.0;  // that the channels have, a share of each; 0 or more
};

struct DiscrepancyStudy {
  Profile profile;
  StudiedSpectra spectra;  // aims are not used
  int components = 6;
  std::vector<JudgedChannels> channels;
  int halvings = 0;  // from 0
  std::uint64_t seed = 1;
};

// 320–400, 400–700 and 700–1000 nm, as far as measured.
enum class GainRange { ultraviolet, visible, nearInfrared };
inline constexpr std::size_t kGainRangeCount = 3;

// Medians over the people of a half that was left out, mean over the halves; NaN where nothing was
// measured or nobody left out.
struct DiscrepancyGain {
  double without = 0.0, with = 0.0;
};

struct DiscrepancyFigures {
  Discrepancies discrepancies;
  std::vector<std::array<DiscrepancyGain, kGainRangeCount>> gains;  // [channels][GainRange]
};

// The fewest spectra that can be halved.
std::size_t fewestToHalve(const DiscrepancyStudy& study);

// Both kinds are learned: of the spectra as they are where the surface's reflection is included,
// and with that taken off; where it is not, it is added for the other kind. Aperture losses belong
// to neither. Judged is the kind that includes the surface, learned from one half of the people and
// applied to the other, in turns.
//
// Errors: those of learnDiscrepancy() and of a layer table; cancelled if asked to stop. Two seconds
// for fifty people, and as much for each halving. Preconditions: spectra within the grid, at least
// two wavelengths; with halvings at least fewestToHalve(). Rigs that validate() passes.
Result<DiscrepancyFigures> runDiscrepancyStudy(const DiscrepancyStudy& study,
                                               const JobContext& context);

}  // namespace cutis
