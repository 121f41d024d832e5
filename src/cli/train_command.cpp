// train: the networks of a rig and a profile.

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "src/app/network_errors.h"
#include "src/app/network_training.h"
#include "src/cli/command.h"
#include "src/cli/option_values.h"
#include "src/cli/output_check.h"
#include "src/cli/text_table.h"
#include "src/files/profile_file.h"
#include "src/files/rig_file.h"

namespace cutis {
namespace {

constexpr int kMostSeed = 1'000'000'000;
constexpr int kMostEpochs = 100'000;
constexpr int kFewestPeople = 1'000;
constexpr int kMostPeople = 10'000'000;
constexpr int kMostTableStep = 10'000;
constexpr int kMostHiddenLayers = 8;
// Between the people the two networks are trained on.
constexpr std::uint64_t kSeedDistance = 10;

struct TrainCommand {
  std::string rig;
  std::string output;
  std::string profile = kDefaultProfile;
  std::string lights;
  std::string seed;
  std::string hidden;
  std::string epochs;
  std::string noise;
  std::string preset;
  std::string people;
  std::string tableStep;
};

// Options that change the networks, as they stand in the file.
std::string recordedCommand(const TrainCommand& command) {
  std::string text = "train --rig " + command.rig + " --profile " + command.profile;
  for (const auto& [option, value] : {std::pair{" --lights ", command.lights},
                                      {" --preset ", command.preset},
                                      {" --seed ", command.seed},
                                      {" --hidden ", command.hidden},
                                      {" --epochs ", command.epochs},
                                      {" --noise ", command.noise},
                                      {" --people ", command.people},
                                      {" --table-step ", command.tableStep}}) {
    if (!value.empty()) text += option + value;
  }
  return text;
}

Status setPreset(const std::string& preset, NetworkTraining& training) {
  if (preset.empty() || preset == "default") return {};
  if (preset != "paper") {
    return usageError("--preset", "'" + preset + "' is unknown; choose default or paper");
  }
  training.spectra = paperSpectraNetworkOptions();
  training.chromophores = paperChromophoreNetworkOptions();
  return {};
}

Status setHidden(const std::string& text, NetworkTraining& training) {
  std::vector<int> hidden;
  for (const std::string& field : commaSeparated(text)) {
    CUTIS_TRY(units, wholeNumber("--hidden", field, 1, kMaximumUnits));
    hidden.push_back(units);
  }
  if (hidden.size() > kMostHiddenLayers) {
    return usageError("--hidden", "more than " + std::to_string(kMostHiddenLayers) +
                                      " hidden layers; give fewer");
  }
  training.spectra.hidden = hidden;
  training.chromophores.hidden = hidden;
  return {};
}

Status setSizes(const TrainCommand& command, NetworkTraining& training) {
  if (!command.hidden.empty()) CUTIS_CHECK(setHidden(command.hidden, training));
  if (!command.epochs.empty()) {
    CUTIS_TRY(epochs, wholeNumber("--epochs", command.epochs, 1, kMostEpochs));
    training.spectra.trainer.epochs = epochs;
    training.chromophores.trainer.epochs = epochs;
  }
  if (!command.people.empty()) {
    CUTIS_TRY(people, wholeNumber("--people", command.people, kFewestPeople, kMostPeople));
    training.spectra.people.count = people;
    training.chromophores.people.count = people;
  }
  if (!command.tableStep.empty()) {
    CUTIS_TRY(step, wholeNumber("--table-step", command.tableStep, 1, kMostTableStep));
    training.tableStep = step;
  }
  return {};
}

Result<NetworkTraining> trainingOf(const TrainCommand& command, const NoiseModel& rigNoise) {
  NetworkTraining training;
  training.chromophores.noise = rigNoise;
  CUTIS_CHECK(setPreset(command.preset, training));
  CUTIS_CHECK(setSizes(command, training));
  if (!command.seed.empty()) {
    CUTIS_TRY(number, wholeNumber("--seed", command.seed, 0, kMostSeed));
    const auto seed = static_cast<std::uint64_t>(number);
    training.spectra.people.seed = training.spectra.trainer.seed = seed;
    training.chromophores.people.seed = seed + kSeedDistance;
    training.chromophores.trainer.seed = seed;
  }
  if (!command.noise.empty()) {
    CUTIS_TRY(noise, realNumbers("--noise", command.noise, 2, 0.0, 1.0));
    training.chromophores.noise = {noise[0], noise[1]};
  }
  training.command = recordedCommand(command);
  return training;
}

Result<Rig> rigOf(const TrainCommand& command) {
  CUTIS_TRY(rig, loadRig(command.rig, {}, "--rig"));
  if (command.lights.empty()) return rig;
  return withLights(rig, commaSeparated(command.lights), "--lights");
}

std::string tableOf(const TrainedNetworks& trained, const NetworkErrors& errors) {
  TextTable figures({"", ""});
  figures.add({"components", std::to_string(trained.components())});
  figures.add({"truncation error, 300-1000 nm",
               shortScientific(trained.basis.truncationError(trained.components()))});
  figures.add(
      {"weights of SpectraNN", std::to_string(trained.file.spectra.network.parameterCount())});
  figures.add(
      {"weights of ChromNN", std::to_string(trained.file.chromophores.network.parameterCount())});
  figures.add({"seconds", fixedNumber(trained.seconds, 1)});
  TextTable table({"mean squared error, 400-700 nm", "no noise", "the rig's noise"});
  table.add({"SpectraNN", shortScientific(errors.decoded), "-"});
  table.add({"ChromNN and the skin model", shortScientific(errors.encoded),
             shortScientific(errors.encodedNoisy)});
  table.add(
      {"ChromNN and SpectraNN", shortScientific(errors.both), shortScientific(errors.bothNoisy)});
  return figures.text().substr(1) + "\n" + table.text();
}

Status runTrainCommand(const TrainCommand& command, Session& session) {
  CUTIS_CHECK(checkTextOutput(command.output, {command.rig, command.profile}));
  CUTIS_TRY(rig, rigOf(command));
  CUTIS_TRY(training, trainingOf(command, rig.noise));
  CUTIS_TRY(model, session.engine.model(command.profile, "--profile"));
  NetworkTrainingState state;
  CUTIS_TRY(trained, trainNetworks(*model, rig, training, state, session.context));
  CUTIS_TRY(errors, measureNetworks(*model, rig, trained.file, session.context));
  CUTIS_CHECK(writeNetworks(command.output, trained.file));
  session.clearProgress();
  const std::string text = tableOf(trained, errors);
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) {
    return {};
  }
  return resourceError("standard output", "the tables could not be written");
}

void addSizes(CLI::App& command, TrainCommand& options) {
  command
      .add_option("--hidden", options.hidden,
                  "Units of the hidden layers of both networks, with commas between them "
                  "(default: 32,32,32 for SpectraNN and 32,32 for ChromNN)")
      ->type_name("N,...");
  command
      .add_option("--epochs", options.epochs,
                  "Times through all people (default: 50 for SpectraNN and 40 for ChromNN)")
      ->type_name("N");
  command.add_option("--people", options.people, "People to train on (default: 300000)")
      ->type_name("N");
  command
      .add_option("--table-step", options.tableStep,
                  "Take the principal components from every so manieth entry of the table of "
                  "skin, for quick trials (default: 1)")
      ->type_name("N");
}

}  // namespace

void addTrainCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<TrainCommand>();
  CLI::App& command = addCommand(app, invocation, "train",
                                 "Train the networks that fit --method network answers with",
                                 options, runTrainCommand);
  command.add_option("--rig", options->rig, "Camera and lights: a built-in name or a JSON file")
      ->required()
      ->type_name("NAME|FILE");
  command.add_option("-o,--output", options->output, "Weights to write")
      ->required()
      ->type_name("WEIGHTS.json");
  command
      .add_option("--profile", options->profile,
                  std::string("Skin model: a built-in name or a JSON file (default: ") +
                      kDefaultProfile + ")")
      ->type_name("NAME|FILE");
  command
      .add_option("--lights", options->lights,
                  "Lights of the rig to use, with commas between them (default: all)")
      ->type_name("LIGHT,...");
  command
      .add_option("--noise", options->noise,
                  "Standard deviations of a channel, constant and proportional, of the photographs "
                  "to learn from (default: the rig's)")
      ->type_name("READ,PROP");
  command
      .add_option("--preset", options->preset,
                  "default, or paper: sizes, activations and rates of Li et al. 2024, without "
                  "noise")
      ->type_name("default|paper");
  addSizes(command, *options);
  command.add_option("--seed", options->seed, "Of the random numbers (default: 1)")->type_name("N");
}

}  // namespace cutis
