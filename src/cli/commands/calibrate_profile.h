#pragma once

// A profile from measured spectra: its constants, their intervals, its prior, and how well it does
// on spectra that were left out.

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "src/cli/commands/validate/validation.h"
#include "src/files/measured_spectra.h"
#include "src/files/profiles/calibration_file.h"

namespace cutis {

struct CalibrationInput {
  CalibrationRecipe recipe;
  std::vector<MeasuredSpectra> spectra;  // as the recipe has them
  Rig colorRig;                          // what sees the colours of validation.h
  int halvings = 0;  // times the spectra are halved, calibrated on one half and judged on the other
  int bootstraps = 0;  // calibrations on spectra drawn again with replacement
  std::uint64_t seed = 1;
};

struct ConstantFigures {
  std::string name;  // as in the recipe; "NAME specular_share" of spectra
  double start = 0.0;
  double value = 0.0;
  double low = 0.0, high = 0.0;  // 5 and 95 % of the bootstraps; NaN without
};

// Mean RMSE over some range, of the spectra calibrated on and of those left out.
struct CalibrationError {
  std::string spectra;
  std::string range;
  double all = 0.0;
  double leftOut = 0.0, worst = 0.0;  // mean and greatest over the halves; NaN without
};

struct CalibratedProfile {
  std::string text;  // of profile.json
  std::vector<ConstantFigures> constants;
  std::vector<CalibrationError> errors;
};

// Checks that the spectra fit the recipe: as many files, wavelengths enough for every aim, spectra
// enough to halve. `places` name them in errors.
Status checkSpectra(const CalibrationInput& input, const std::vector<std::string>& places);

// Same input, same output, for any number of threads. Precondition: checkSpectra() passed. About 3
// s a calibration of 4000 spectra on two cores and as much for each halving and bootstrap, besides
// validation.
Result<CalibratedProfile> calibrateProfile(const CalibrationInput& input,
                                           const JobContext& context);

}  // namespace cutis
