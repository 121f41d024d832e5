// calibrate-profile: the constants and the prior of a profile from measured spectra, or what its
// model leaves over of them.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "src/cli/command.h"
#include "src/cli/commands/learn_discrepancy.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/option_values.h"
#include "src/cli/output_check.h"
#include "src/cli/standard_output.h"
#include "src/cli/text_table.h"
#include "src/files/io/atomic_write.h"
#include "src/files/profiles/calibrated_profile.h"
#include "src/files/rig_file.h"
#include "src/files/spectra/measured_spectra_file.h"

namespace cutis {
namespace {

constexpr char kColorRig[] = "albedo";
constexpr WavelengthRange kCalibratedRange = {kFirstWavelengthNm, kLastWavelengthNm};
constexpr std::size_t kFewest = kParameterCount + 1;
constexpr int kMostRepetitions = 1000;
constexpr int kMostCalibrationSeed = 1000000000;
constexpr int kUsualHalvings = 6;
constexpr int kUsualBootstraps = 30;
constexpr int kTableDecimals = 4;

struct CalibrateCommand {
  std::string recipe;
  std::vector<std::string> spectra;
  std::string output;
  std::string halvings;
  std::string bootstraps;
  std::string seed;
};

Result<int> repetitions(const std::string& option, const std::string& text, int usual) {
  if (text.empty()) return usual;
  return wholeNumber(option, text, 0, kMostRepetitions);
}

// What the command line names, read.
struct CalibrationInput {
  CalibrationRecipe recipe;
  std::vector<MeasuredSpectra> spectra;  // as the recipe has them
};

// Whether the spectra fit the recipe: as many files, wavelengths enough for every aim, spectra
// enough to halve. `places` name them in errors.
Status checkSpectra(const CalibrationInput& input, int halvings,
                    const std::vector<std::string>& places) {
  const CalibrationRecipe& recipe = input.recipe;
  if (input.spectra.size() != recipe.spectra.size()) {
    const std::size_t files = recipe.spectra.size();
    return usageError("SPECTRA", "the calibration " + recipe.name + " takes " +
                                     std::to_string(files) + (files == 1 ? " file" : " files") +
                                     ", given were " + std::to_string(input.spectra.size()));
  }
  const std::size_t fewest = halvings > 0 ? 4 : 2;
  for (std::size_t i = 0; i < input.spectra.size(); ++i) {
    const MeasuredSpectra& spectra = input.spectra[i];
    if (spectra.ids.size() < fewest) {
      return inputError(places[i], "too few spectra: " + std::to_string(spectra.ids.size()) +
                                       " where at least " + std::to_string(fewest) + " are needed");
    }
    std::vector<SpectralAim> aims = recipe.spectra[i].aims;
    if (recipe.learnsDiscrepancy()) aims = {SpectralAim{}};
    for (const SpectralAim& aim : aims) {
      const double from = std::min(aim.fromNm, kFittedFromNm);
      const double to = std::max(aim.toNm, kFittedToNm);
      if (spectra.wavelengthsNm.front() <= from && spectra.wavelengthsNm.back() >= to) continue;
      return inputError(places[i], "the calibration compares " + formatNumber(from) + " to " +
                                       formatNumber(to) + " nm, measured are " +
                                       formatNumber(spectra.wavelengthsNm.front()) + " to " +
                                       formatNumber(spectra.wavelengthsNm.back()) + " nm");
    }
  }
  return {};
}

Result<CalibrationInput> readInput(const CalibrateCommand& command, int halvings,
                                   const JobContext& context) {
  CalibrationInput input;
  CUTIS_TRY(recipe, loadCalibrationRecipe(command.recipe, "RECIPE"));
  input.recipe = recipe;
  for (const std::string& path : command.spectra) {
    CUTIS_TRY(spectra, readMeasuredSpectra(path, kCalibratedRange, kFewest, context));
    input.spectra.push_back(std::move(spectra));
  }
  CUTIS_CHECK(checkSpectra(input, halvings, command.spectra));
  return input;
}

// How much is run, and by which random numbers.
struct Repetitions {
  int halvings = 0;
  int bootstraps = 0;
  std::uint64_t seed = 1;
};
Result<Repetitions> repetitionsOf(const CalibrateCommand& command) {
  Repetitions asked;
  CUTIS_TRY(halvings, repetitions("--halvings", command.halvings, kUsualHalvings));
  CUTIS_TRY(bootstraps, repetitions("--bootstraps", command.bootstraps, kUsualBootstraps));
  asked.halvings = halvings;
  asked.bootstraps = bootstraps;
  if (command.seed.empty()) return asked;
  CUTIS_TRY(seed, wholeNumber("--seed", command.seed, 0, kMostCalibrationSeed));
  asked.seed = static_cast<std::uint64_t>(seed);
  return asked;
}

std::string tablesOf(const CalibrationRecipe& recipe, const CalibrationStudy& study,
                     const CalibrationFigures& figures) {
  TextTable constants({"constant", "before", "calibrated", "5 %", "95 %"});
  for (std::size_t k = 0; k < figures.constants.size(); ++k) {
    const ConstantFigures& constant = figures.constants[k];
    const auto interval = [](double value) {
      return std::isnan(value) ? std::string("-") : formatNumber(value);
    };
    constants.add({constantLabel(recipe, recipe.constants[k]),
                   formatNumber(study.constants[k].start), formatNumber(constant.value),
                   interval(constant.low), interval(constant.high)});
  }
  TextTable errors({"mean RMSE of", "over", "all", "left out", "worst half"}, 2);
  for (std::size_t i = 0; i < figures.errors.size(); ++i) {
    for (std::size_t range = 0; range < kJudgedRangeCount; ++range) {
      const CalibrationError& error = figures.errors[i][range];
      if (std::isnan(error.all)) continue;
      errors.add({recipe.spectra[i].name, judgedRangeLabel(static_cast<JudgedRange>(range)),
                  fixedNumber(error.all, kTableDecimals),
                  fixedNumber(error.leftOut, kTableDecimals),
                  fixedNumber(error.worst, kTableDecimals)});
    }
  }
  return constants.text() + "\n" + errors.text();
}

Status runLearning(const CalibrateCommand& command, const CalibrationInput& input,
                   const Repetitions& asked, Session& session) {
  if (!command.bootstraps.empty()) {
    return usageError("--bootstraps", "the calibration " + input.recipe.name +
                                          " keeps all constants and has no intervals to find; "
                                          "leave the option out");
  }
  CUTIS_TRY(learned, learnProfile(input.recipe, input.spectra.front(), asked.halvings, asked.seed,
                                  command.spectra.front(), session.context));
  CUTIS_CHECK(writeTextAtomically(command.output, learned.text));
  session.clearProgress();
  return printText(learned.table, kTablesLost);
}

Status runCalibrateCommand(const CalibrateCommand& command, Session& session) {
  std::vector<std::string> inputs = command.spectra;
  inputs.push_back(command.recipe);
  CUTIS_CHECK(checkTextOutput(command.output, inputs));
  CUTIS_TRY(asked, repetitionsOf(command));
  CUTIS_TRY(input,
            readInput(command, asked.halvings, {session.context.stop, {}, session.context.notice}));
  if (input.recipe.learnsDiscrepancy()) return runLearning(command, input, asked, session);
  CUTIS_TRY(study, studyOf(input.recipe, input.spectra));
  study.halvings = asked.halvings;
  study.bootstraps = asked.bootstraps;
  study.seed = asked.seed;
  CUTIS_TRY(rig, loadRig(kColorRig, {}, "rig"));
  study.colorRig = rig;
  CUTIS_TRY(figures, runStudy(study, session.context));
  CUTIS_TRY(text, calibratedProfileText(input.recipe, figures));
  CUTIS_CHECK(writeTextAtomically(command.output, text));
  session.clearProgress();
  return printText(tablesOf(input.recipe, study, figures), kTablesLost);
}

}  // namespace

void addCalibrateProfileCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<CalibrateCommand>();
  CLI::App& command = addCommand(
      app, invocation, "calibrate-profile",
      "Find a profile's constants and prior, or what its model leaves over, from measured "
      "reflectance spectra",
      options, runCalibrateCommand);
  addOption(command, "RECIPE", options->recipe, "NAME|FILE",
            "What is calibrated and how: a built-in name or a JSON file")
      ->required();
  addOption(command, "SPECTRA", options->spectra, "",
            "Comma-separated values as for fit-spectra, a file for each set of spectra the "
            "recipe names, in its order")
      ->required();
  addOption(command, "-o", options->output, "PROFILE.json", "The profile to write")->required();
  addOption(command, "--halvings", options->halvings, "N",
            "Times to halve the spectra at random, calibrate on each half and judge on the "
            "other (default: 6)");
  addOption(command, "--bootstraps", options->bootstraps, "N",
            "Calibrations on spectra drawn again, for the intervals of the constants "
            "(default: 30; not where all constants are kept)");
  addOption(command, "--seed", options->seed, "N", "Seed of the random numbers (default: 1)");
}

}  // namespace cutis
