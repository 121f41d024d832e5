// calibrate-profile: the constants and the prior of a profile from measured spectra.

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "src/cli/command.h"
#include "src/cli/commands/calibrate_profile.h"
#include "src/cli/options/arguments.h"
#include "src/cli/options/option_values.h"
#include "src/cli/output_check.h"
#include "src/cli/text_table.h"
#include "src/files/io/atomic_write.h"
#include "src/files/io/csv.h"
#include "src/files/rig_file.h"

namespace cutis {
namespace {

constexpr char kColorRig[] = "albedo";
constexpr WavelengthRange kCalibratedRange = {kFirstWavelengthNm, kLastWavelengthNm};
constexpr std::size_t kFewest = kParameterCount + 1;
constexpr int kMostRepetitions = 1000;
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

Result<CalibrationInput> readInput(const CalibrateCommand& command, const JobContext& context) {
  CalibrationInput input;
  CUTIS_TRY(halvings, repetitions("--halvings", command.halvings, kUsualHalvings));
  CUTIS_TRY(bootstraps, repetitions("--bootstraps", command.bootstraps, kUsualBootstraps));
  input.halvings = halvings;
  input.bootstraps = bootstraps;
  if (!command.seed.empty()) {
    CUTIS_TRY(seed, wholeNumber("--seed", command.seed, 0, 1000000000));
    input.seed = static_cast<std::uint64_t>(seed);
  }
  CUTIS_TRY(recipe, loadCalibrationRecipe(command.recipe, "RECIPE"));
  CUTIS_TRY(rig, loadRig(kColorRig, {}, "rig"));
  input.recipe = recipe;
  input.colorRig = rig;
  for (const std::string& path : command.spectra) {
    CUTIS_TRY(spectra, readMeasuredSpectra(path, kCalibratedRange, kFewest, context));
    input.spectra.push_back(std::move(spectra));
  }
  CUTIS_CHECK(checkSpectra(input, command.spectra));
  return input;
}

std::string tablesOf(const CalibratedProfile& calibrated) {
  TextTable constants({"constant", "before", "calibrated", "5 %", "95 %"});
  for (const ConstantFigures& figures : calibrated.constants) {
    const auto interval = [](double value) {
      return std::isnan(value) ? std::string("-") : formatNumber(value);
    };
    constants.add({figures.name, formatNumber(figures.start), formatNumber(figures.value),
                   interval(figures.low), interval(figures.high)});
  }
  TextTable errors({"mean RMSE of", "over", "all", "left out", "worst half"}, 2);
  for (const CalibrationError& error : calibrated.errors) {
    if (std::isnan(error.all)) continue;
    errors.add({error.spectra, error.range, fixedNumber(error.all, kTableDecimals),
                fixedNumber(error.leftOut, kTableDecimals),
                fixedNumber(error.worst, kTableDecimals)});
  }
  return constants.text() + "\n" + errors.text();
}

Status runCalibrateCommand(const CalibrateCommand& command, Session& session) {
  std::vector<std::string> inputs = command.spectra;
  inputs.push_back(command.recipe);
  CUTIS_CHECK(checkTextOutput(command.output, inputs));
  CUTIS_TRY(input, readInput(command, {session.context.stop, {}, {}}));
  CUTIS_TRY(calibrated, calibrateProfile(input, session.context));
  CUTIS_CHECK(writeTextAtomically(command.output, calibrated.text));
  session.clearProgress();
  const std::string text = tablesOf(calibrated);
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) {
    return {};
  }
  return resourceError("standard output", "the tables could not be written");
}

}  // namespace

void addCalibrateProfileCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<CalibrateCommand>();
  CLI::App& command =
      addCommand(app, invocation, "calibrate-profile",
                 "Find a profile's constants and prior from measured reflectance spectra", options,
                 runCalibrateCommand);
  command
      .add_option("RECIPE", options->recipe,
                  "What is calibrated and how: a built-in name or a JSON file")
      ->required()
      ->type_name("NAME|FILE");
  command
      .add_option("SPECTRA", options->spectra,
                  "Comma-separated values as for fit-spectra, a file for each set of spectra the "
                  "recipe names, in its order")
      ->required()
      ->type_name("");
  command.add_option("-o", options->output, "The profile to write")
      ->required()
      ->type_name("PROFILE.json");
  command
      .add_option("--halvings", options->halvings,
                  "Times to halve the spectra at random, calibrate on each half and judge on the "
                  "other (default: 6)")
      ->type_name("N");
  command
      .add_option("--bootstraps", options->bootstraps,
                  "Calibrations on spectra drawn again, for the intervals of the constants "
                  "(default: 30)")
      ->type_name("N");
  command.add_option("--seed", options->seed, "Of the random numbers (default: 1)")->type_name("N");
}

}  // namespace cutis
