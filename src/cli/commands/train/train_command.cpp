// train: the networks of a rig and a profile.

#include <string>
#include <utility>
#include <vector>

#include "src/app/training/network_errors.h"
#include "src/app/training/network_training.h"
#include "src/app/training/training_keeper.h"
#include "src/cli/command.h"
#include "src/cli/commands/train/train_plot.h"
#include "src/cli/commands/train/train_report.h"
#include "src/cli/commands/train/train_sizes.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/train_options.h"
#include "src/cli/output_check.h"
#include "src/cli/standard_output.h"
#include "src/report/picture_file.h"

namespace cutis {
namespace {

struct TrainCommand {
  TrainOptions options;
  std::string output;
  std::string state;
  std::string plot;
  std::string sizes;
};

// A comparison of sizes prints its table and writes nothing.
Status checkComparison(const TrainCommand& command) {
  for (const auto& [option, value] : {std::pair{"--output", command.output},
                                      {"--state", command.state},
                                      {"--plot", command.plot}}) {
    if (!value.empty()) {
      return usageError(option, "--sizes prints a table and writes no file; leave one of them out");
    }
  }
  return checkSizes(command.sizes);
}

Status checkOutputs(const TrainCommand& command) {
  if (!command.sizes.empty()) return checkComparison(command);
  if (command.output.empty())
    return usageError("train", "-o is required; name the weights to write");
  const std::vector<std::string> inputs = {command.options.rig, command.options.profile};
  CUTIS_CHECK(checkTextOutput(command.output, inputs));
  CUTIS_CHECK(checkDistinct(command.state, command.output));
  CUTIS_CHECK(checkDistinct(command.plot, command.output));
  CUTIS_CHECK(checkDistinct(command.plot, command.state));
  if (!command.state.empty()) CUTIS_CHECK(checkTextOutput(command.state, inputs));
  if (command.plot.empty()) return {};
  CUTIS_CHECK(checkNotInput(command.plot, inputs));
  return checkDrawingOutput(command.plot);
}

Result<TrainedNetworks> train(const SkinModel& model, const Rig& rig,
                              const NetworkTraining& training, TrainingKeeper& keeper,
                              const JobContext& context) {
  CUTIS_TRY(state, keeper.load());
  auto trained = trainNetworks(model, rig, training, state, context,
                               [&](const NetworkEpoch&) { keeper.keep(state, context); });
  if (trained.cancelled()) CUTIS_CHECK(keeper.save(state));
  if (trained.failed()) return keeper.explained(trained.failure());
  return trained;
}

Status runTrainCommand(const TrainCommand& command, Session& session) {
  CUTIS_CHECK(checkOutputs(command));
  CUTIS_TRY(rig, trainedRig(command.options, session.context.notice));
  CUTIS_TRY(training, trainingOf(command.options, rig.noise));
  CUTIS_TRY(model, session.engine.model(command.options.profile, "--profile"));
  if (!command.sizes.empty()) {
    CUTIS_TRY(table, sizesTable(command.sizes, *model, rig, training, session.context));
    session.clearProgress();
    return printText(table, kTablesLost);
  }
  CUTIS_TRY(identity, trainingIdentity(*model, rig, training));
  TrainingKeeper keeper(command.state, training.command, identity);
  CUTIS_TRY(trained, train(*model, rig, training, keeper, session.context));
  CUTIS_TRY(errors, measureNetworks(*model, rig, trained.file, session.context));
  CUTIS_CHECK(writeNetworks(command.output, trained.file));
  if (!command.plot.empty()) CUTIS_CHECK(writeDrawing(command.plot, trainPlot(*model, trained)));
  CUTIS_CHECK(keeper.remove());
  session.clearProgress();
  return printText(trainReport(trained, errors), kTablesLost);
}

}  // namespace

void addTrainCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<TrainCommand>();
  CLI::App& command = addCommand(app, invocation, "train",
                                 "Train the networks that fit --method network answers with",
                                 options, runTrainCommand);
  addTrainOptions(command, options->options);
  addOption(command, "-o,--output", options->output, "WEIGHTS.json", "Weights to write");
  addOption(command, "--state", options->state, "STATE.json",
            "Keep the state of the training in this file every few seconds; the same "
            "command goes on from it after an interruption, to the same weights; deleted "
            "once they are written");
  addOption(command, "--plot", options->plot, "FILE",
            "Picture to draw, .svg or .png: errors by epoch, what principal components leave, "
            "the components, and a spectrum rebuilt from them");
  addOption(command, "--sizes", options->sizes, "N,...;...",
            "Instead of writing weights, train networks with each of these hidden layers and "
            "print what they cost and how good they are: \"16,16;default;64,64\"");
}

}  // namespace cutis
