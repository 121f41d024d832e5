#include "src/files/profiles/calibrated_profile.h"

#include <cmath>
#include <span>
#include <utility>

#include "core/base/number_text.h"
#include "src/files/profiles/profile_edit.h"
#include "src/files/profiles/profile_file.h"

namespace cutis {
namespace {

constexpr char kMadePlace[] = "the calibrated profile";
constexpr int kErrorDecimals = 4;

// Everything that constants change in the profile.
ProfileEdits editsFor(const CalibrationRecipe& recipe, std::span<const double> constants) {
  ProfileEdits edits;
  for (std::size_t k = 0; k < constants.size(); ++k) {
    if (recipe.constants[k].spectra) continue;
    edits.numbers.emplace_back(recipe.constants[k].constant.name, constants[k]);
  }
  return edits;
}

std::string sourceOf(const CalibrationConstant& constant, const ConstantFigures& figures) {
  std::string text = "Calibrated";
  if (!std::isnan(figures.low)) {
    text += ": " + formatNumber(figures.low) + " to " + formatNumber(figures.high);
  }
  return text + "." + (constant.note.empty() ? "" : " " + constant.note);
}

std::string descriptionOf(const CalibrationRecipe& recipe, const CalibrationFigures& figures) {
  std::string errors;
  for (std::size_t i = 0; i < figures.errors.size(); ++i) {
    for (std::size_t range = 0; range < kJudgedRangeCount; ++range) {
      const double leftOut = figures.errors[i][range].leftOut;
      if (std::isnan(leftOut)) continue;
      errors += " " + recipe.spectra[i].name + " " +
                judgedRangeLabel(static_cast<JudgedRange>(range)) + " " +
                fixedNumber(leftOut, kErrorDecimals) + ";";
    }
  }
  if (errors.empty()) return recipe.description;
  errors.back() = '.';
  return recipe.description + " Mean RMSE on halves left out:" + errors;
}

}  // namespace

Result<CalibrationStudy> studyOf(const CalibrationRecipe& recipe,
                                 const std::vector<MeasuredSpectra>& spectra) {
  CalibrationStudy study;
  for (std::size_t i = 0; i < spectra.size(); ++i) {
    const CalibrationSpectra& described = recipe.spectra[i];
    study.spectra.push_back({spectra[i], described.specular, described.specularShare,
                             described.edgeLossPerMm, described.aims});
  }
  for (const CalibrationConstant& constant : recipe.constants) {
    if (constant.spectra) {
      study.constants.push_back(
          {constant.constant, recipe.spectra[*constant.spectra].specularShare, constant.spectra});
      continue;
    }
    CUTIS_TRY(start, profileNumber(recipe.startText, constant.constant.name, recipe.start));
    study.constants.push_back({constant.constant, start, {}});
  }
  study.profileAt = [&recipe](std::span<const double> constants) {
    return parseProfile(editedProfile(recipe.startText, editsFor(recipe, constants)), kMadePlace);
  };
  study.stepNm = recipe.stepNm;
  study.pull = recipe.pull;
  study.priorSpectra = recipe.priorSpectra;
  study.priorNoise = recipe.priorNoise;
  return study;
}

Result<std::string> calibratedProfileText(const CalibrationRecipe& recipe,
                                          const CalibrationFigures& figures) {
  std::vector<double> constants;
  for (const ConstantFigures& constant : figures.constants)
    constants.push_back(constant.value);
  ProfileEdits edits = editsFor(recipe, constants);
  edits.name = recipe.name;
  edits.description = descriptionOf(recipe, figures);
  edits.prior = figures.prior;
  for (std::size_t k = 0; k < constants.size(); ++k) {
    const CalibrationConstant& constant = recipe.constants[k];
    if (constant.spectra) continue;
    edits.sources.emplace_back(constant.constant.name, sourceOf(constant, figures.constants[k]));
  }
  std::string text = editedProfile(recipe.startText, edits);
  CUTIS_CHECK(parseProfile(text, kMadePlace));
  return text;
}

Result<DiscrepancyStudy> discrepancyStudyOf(const CalibrationRecipe& recipe,
                                            const MeasuredSpectra& spectra) {
  DiscrepancyStudy study;
  CUTIS_TRY(profile, parseProfile(recipe.startText, recipe.start));
  study.profile = profile;
  const CalibrationSpectra& described = recipe.spectra.front();
  study.spectra = {
      spectra, described.specular, described.specularShare, described.edgeLossPerMm, {}};
  study.components = recipe.components;
  return study;
}

Result<std::string> learnedProfileText(const CalibrationRecipe& recipe,
                                       const Discrepancies& discrepancies, std::size_t people) {
  ProfileEdits edits;
  edits.name = recipe.name;
  edits.description = recipe.description;
  edits.discrepancies = discrepancies;
  edits.sources.emplace_back("discrepancy", "Learned from " + std::to_string(people) +
                                                " spectra of " + recipe.spectra.front().name + ".");
  std::string text = editedProfile(recipe.startText, edits);
  CUTIS_CHECK(parseProfile(text, kMadePlace));
  return text;
}

std::string constantLabel(const CalibrationRecipe& recipe, const CalibrationConstant& constant) {
  const std::string& field = constant.constant.name;
  return constant.spectra ? recipe.spectra[*constant.spectra].name + " " + field : field;
}

const char* judgedRangeLabel(JudgedRange range) {
  switch (range) {
    case JudgedRange::fitted:
      return "400-700 nm";
    case JudgedRange::ultraviolet:
      return "320-400 nm, predicted";
    case JudgedRange::nearInfrared:
      return "700-1000 nm, predicted";
    case JudgedRange::fromColor:
      return "400-700 nm from colour, median";
  }
  return "";
}

}  // namespace cutis
