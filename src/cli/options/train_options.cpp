#include "src/cli/options/train_options.h"

#include <utility>

#include "core/base/echoed_text.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/option_values.h"
#include "src/files/rig_file.h"

namespace cutis {
namespace {

constexpr int kMostSeed = 1'000'000'000;
constexpr int kMostEpochs = 100'000;
constexpr int kFewestTrainingPeople = 1'000;
constexpr int kMostTrainingPeople = 10'000'000;
constexpr int kMostTableStep = 10'000;
constexpr int kMostHiddenLayers = 8;
constexpr int kSmallestBatch = 96;
constexpr int kLargestBatch = 65'536;
constexpr double kLeastRate = 1e-9;
// The distance of the seeds for the people that the two networks are trained on.
constexpr std::uint64_t kSeedDistance = 10;

// Options that change the networks, as they stand in the file.
std::string recordedCommand(const TrainOptions& options) {
  std::string text = "train --rig " + options.rig + " --profile " + options.profile;
  for (const auto& [option, value] : {std::pair{" --lights ", options.lights},
                                      {" --channels ", options.channels},
                                      {" --preset ", options.preset},
                                      {" --noise ", options.noise},
                                      {" --hidden ", options.hidden},
                                      {" --activation ", options.activation},
                                      {" --components ", options.components},
                                      {" --people ", options.people},
                                      {" --table-step ", options.tableStep},
                                      {" --epochs ", options.epochs},
                                      {" --patience ", options.patience},
                                      {" --rate ", options.rate},
                                      {" --weight-decay ", options.weightDecay},
                                      {" --batch ", options.batch},
                                      {" --seed ", options.seed}}) {
    if (!value.empty()) text += option + value;
  }
  return text;
}

// Changes the options of both networks alike.
template <typename Change>
void setBoth(NetworkTraining& training, const Change& change) {
  change(training.spectra);
  change(training.chromophores);
}

Status setPreset(const std::string& preset, NetworkTraining& training) {
  if (preset.empty() || preset == "default") return {};
  if (preset != "paper") {
    return usageError("--preset", inQuotes(preset) + " is unknown; choose default or paper");
  }
  training.spectra = paperSpectraNetworkOptions();
  training.chromophores = paperChromophoreNetworkOptions();
  return {};
}

Status setChannels(const std::string& channels, NetworkTraining& training) {
  if (channels.empty() || channels == "all") return {};
  if (channels != "paper") {
    return usageError("--channels", inQuotes(channels) + " is unknown; choose all or paper");
  }
  training.paperChannels = true;
  return {};
}

Status setActivation(const std::string& name, NetworkTraining& training) {
  const auto activation = activationByName(name);
  if (!activation || *activation == Activation::linear) {
    return usageError("--activation",
                      inQuotes(name) + " is unknown; choose relu, sigmoid or squareplus");
  }
  setBoth(training, [&](auto& options) { options.activation = *activation; });
  return {};
}

Status setComponents(const std::string& text, NetworkTraining& training) {
  training.spectra.components = 0;
  if (text == "auto") return {};
  CUTIS_TRY(components, wholeNumber("--components", text, 1, kMaximumComponents));
  training.spectra.components = components;
  return {};
}

Status setNetworks(const TrainOptions& options, NetworkTraining& training) {
  if (!options.hidden.empty()) {
    CUTIS_TRY(hidden, hiddenLayers("--hidden", options.hidden));
    setBoth(training, [&](auto& network) { network.hidden = hidden; });
  }
  if (!options.activation.empty()) CUTIS_CHECK(setActivation(options.activation, training));
  if (!options.components.empty()) CUTIS_CHECK(setComponents(options.components, training));
  return {};
}

Status setPeople(const TrainOptions& options, NetworkTraining& training) {
  if (!options.people.empty()) {
    CUTIS_TRY(people,
              wholeNumber("--people", options.people, kFewestTrainingPeople, kMostTrainingPeople));
    setBoth(training, [&](auto& network) { network.people.count = people; });
  }
  if (!options.tableStep.empty()) {
    CUTIS_TRY(step, wholeNumber("--table-step", options.tableStep, 1, kMostTableStep));
    training.tableStep = step;
  }
  if (!options.noise.empty()) {
    CUTIS_TRY(noise, realNumbers("--noise", options.noise, 2, 0.0, 1.0));
    training.chromophores.noise = {noise[0], noise[1]};
  }
  return {};
}

Status setTrainer(const TrainOptions& options, TrainerOptions& trainer) {
  if (!options.epochs.empty()) {
    CUTIS_TRY(epochs, wholeNumber("--epochs", options.epochs, 1, kMostEpochs));
    trainer.epochs = epochs;
  }
  if (!options.patience.empty()) {
    CUTIS_TRY(patience, wholeNumber("--patience", options.patience, 0, kMostEpochs));
    trainer.patience = patience;
  }
  if (!options.rate.empty()) {
    CUTIS_TRY(rate, realNumber("--rate", options.rate, kLeastRate, 1.0));
    trainer.rate = rate;
  }
  if (!options.weightDecay.empty()) {
    CUTIS_TRY(decay, realNumber("--weight-decay", options.weightDecay, 0.0, 1.0));
    trainer.weightDecay = decay;
  }
  if (!options.batch.empty()) {
    CUTIS_TRY(batch, wholeNumber("--batch", options.batch, kSmallestBatch, kLargestBatch));
    trainer.batch = batch;
  }
  return {};
}

Status setSeed(const std::string& text, NetworkTraining& training) {
  if (text.empty()) return {};
  CUTIS_TRY(number, wholeNumber("--seed", text, 0, kMostSeed));
  const auto seed = static_cast<std::uint64_t>(number);
  training.spectra.people.seed = training.spectra.trainer.seed = seed;
  training.chromophores.people.seed = seed + kSeedDistance;
  training.chromophores.trainer.seed = seed;
  return {};
}

void addNetworkOptions(CLI::App& command, TrainOptions& options) {
  addOption(command, "--hidden", options.hidden, "N,...",
            "Units of the hidden layers of both networks, separated by commas "
            "(default: 32,32,32 for SpectraNN and 32,32 for ChromNN)");
  addOption(
      command, "--activation", options.activation, "NAME",
      "Activation of the hidden layers of both networks: relu, sigmoid or squareplus (default)");
  addOption(command, "--components", options.components, "N|auto",
            "Principal components of the spectra; auto (default): as few as leave a mean "
            "squared error of 1e-8");
  addOption(command, "--people", options.people, "N", "People to train on (default: 300000)");
  addOption(command, "--table-step", options.tableStep, "N",
            "Take the principal components from every N-th entry of the table of "
            "skin, for quick trials (default: 1)");
}

void addTrainerOptions(CLI::App& command, TrainOptions& options) {
  addOption(command, "--epochs", options.epochs, "N",
            "Passes through all people (default: 50 for SpectraNN and 40 for ChromNN)");
  addOption(command, "--patience", options.patience, "N",
            "Stop a network after N epochs without a smaller error on people held "
            "out; 0 (default): never");
  addOption(command, "--rate", options.rate, "R",
            "Largest learning rate, which rises at first and then falls as a cosine "
            "(default: 0.02)");
  addOption(command, "--weight-decay", options.weightDecay, "D",
            "Share by which a weight shrinks per unit of rate (default: 0)");
  addOption(command, "--batch", options.batch, "N", "People per step (default: 384)");
  addOption(command, "--seed", options.seed, "N", "Seed of the random numbers (default: 1)");
}

}  // namespace

void addTrainOptions(CLI::App& command, TrainOptions& options) {
  addOption(command, "--rig", options.rig, "NAME|FILE",
            "Camera and lights: a built-in name or a JSON file")
      ->required();
  addProfileOption(command, options.profile, kDefaultProfile);
  addOption(command, "--lights", options.lights, "LIGHT,...",
            "Lights of the rig to use, separated by commas (default: all)");
  addOption(command, "--channels", options.channels, "all|paper",
            "all channels of the lights (default), or paper: the five of Li et al. 2024, "
            "r, g, b, sb, sg");
  addOption(command, "--noise", options.noise, "READ,PROP",
            "Standard deviations of a channel, constant and proportional, of the photographs "
            "to learn from (default: the rig's)");
  addOption(command, "--preset", options.preset, "default|paper",
            "default, or paper: sizes, activations and rates of Li et al. 2024, without "
            "noise; the options below change single values of either");
  addNetworkOptions(command, options);
  addTrainerOptions(command, options);
}

NetworkAdvice networkAdvice() {
  return {"--method", "--weights", [](const Profile& profile, const Rig& rig) {
            std::string lights;
            for (const RigLight& light : rig.lights)
              lights += (lights.empty() ? "" : ",") + light.name;
            return "train one with cutis-cli train --rig " +
                   (rig.file.empty() ? rig.name : rig.file) + " --lights " + lights +
                   " --profile " + profile.name + " -o WEIGHTS.json and give it with --weights";
          }};
}

Result<Rig> trainedRig(const TrainOptions& options, const Notice& notice) {
  CUTIS_TRY(rig, loadRig(options.rig, {}, "--rig", notice));
  if (options.lights.empty()) return rig;
  return withLights(rig, commaSeparated(options.lights), "--lights");
}

Result<NetworkTraining> trainingOf(const TrainOptions& options, const NoiseModel& rigNoise) {
  NetworkTraining training;
  training.chromophores.noise = rigNoise;
  CUTIS_CHECK(setPreset(options.preset, training));
  CUTIS_CHECK(setChannels(options.channels, training));
  CUTIS_CHECK(setNetworks(options, training));
  CUTIS_CHECK(setPeople(options, training));
  CUTIS_CHECK(setTrainer(options, training.spectra.trainer));
  CUTIS_CHECK(setTrainer(options, training.chromophores.trainer));
  CUTIS_CHECK(setSeed(options.seed, training));
  training.command = recordedCommand(options);
  return training;
}

Result<std::vector<int>> hiddenLayers(const std::string& option, const std::string& text) {
  std::vector<int> hidden;
  for (const std::string& field : commaSeparated(text)) {
    CUTIS_TRY(units, wholeNumber(option, field, 1, kMaximumUnits));
    hidden.push_back(units);
  }
  if (hidden.empty() || hidden.size() > kMostHiddenLayers) {
    return usageError(option, inQuotes(text) + " is not one to " +
                                  std::to_string(kMostHiddenLayers) +
                                  " hidden layers; give as many, such as 32,32");
  }
  return hidden;
}

}  // namespace cutis
