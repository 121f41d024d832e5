#pragma once  // internal to src/cli/commands

// The part of calibrate-profile that keeps all constants and learns what the model leaves over of
// spectra: its profile and its table.

#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/calibrate/discrepancy_study.h"
#include "src/files/profiles/calibration_file.h"

namespace cutis {

struct LearnedProfile {
  std::string text;   // of the profile.json
  std::string table;  // what knowing the discrepancy gains; empty without halvings
};

// place: of the spectra, for errors. Precondition: recipe.learnsDiscrepancy().
Result<LearnedProfile> learnProfile(const CalibrationRecipe& recipe, const MeasuredSpectra& spectra,
                                    int halvings, std::uint64_t seed, const std::string& place,
                                    const JobContext& context);

}  // namespace cutis
