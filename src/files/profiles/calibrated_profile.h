#pragma once

// From a calibration's recipe to what is studied, and from the study's figures to the profile.json
// that it makes.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/calibrate/calibration_study.h"
#include "core/calibrate/discrepancy_study.h"
#include "src/files/profiles/calibration_file.h"

namespace cutis {

// The study of a recipe on spectra, a set for each that the recipe names; without a rig for
// colours, halvings and bootstraps. Fails where the start has no number in a field.
// The recipe outlives the study.
Result<CalibrationStudy> studyOf(const CalibrationRecipe& recipe,
                                 const std::vector<MeasuredSpectra>& spectra);

// The recipe's start with the constants, the prior, and where they are from; its description says
// the errors on spectra that were left out. Fails if that is no valid profile.
Result<std::string> calibratedProfileText(const CalibrationRecipe& recipe,
                                          const CalibrationFigures& figures);

// The same of a recipe that learns a discrepancy; without channels, halvings and a seed. `spectra`
// are those of its one file.
Result<DiscrepancyStudy> discrepancyStudyOf(const CalibrationRecipe& recipe,
                                            const MeasuredSpectra& spectra);

// The recipe's start with the discrepancies and where they are from. people: how many there were.
Result<std::string> learnedProfileText(const CalibrationRecipe& recipe,
                                       const Discrepancies& discrepancies, std::size_t people);

// "epidermis.thickness_mm", or "leeds specular_share" of a set's own constant.
std::string constantLabel(const CalibrationRecipe& recipe, const CalibrationConstant& constant);
// "320-400 nm, predicted"
const char* judgedRangeLabel(JudgedRange range);

}  // namespace cutis
