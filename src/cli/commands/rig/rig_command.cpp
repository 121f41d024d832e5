// rig: what a rig can tell of skin.

#include <cstdio>

#include "src/cli/command.h"
#include "src/cli/commands/rig/rig_identify.h"
#include "src/cli/options/arguments.h"
#include "src/cli/options/option_values.h"
#include "src/cli/output_check.h"
#include "src/files/profiles/prior_file.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/rig_file.h"
#include "src/report/picture_file.h"

namespace cutis {
namespace {

constexpr int kFewestPeople = 10;
constexpr int kMostPeople = 100000;
constexpr int kUsualPeople = 500;

struct RigCommand {
  std::string action;
  std::string rig = "monitor";
  std::string profile = kDefaultProfile;
  std::string prior;
  std::string noise;
  std::string people;
  std::string plot;
};

Status checkAction(const std::string& action) {
  if (action == "identify") return {};
  if (action == "check" || action == "calibrate") return usageError(action, kNotInThisVersion);
  return usageError("rig", "unknown action '" + action + "'; it is identify");
}

Status runRigCommand(const RigCommand& command, Session& session) {
  CUTIS_CHECK(checkAction(command.action));
  int people = kUsualPeople;
  if (!command.people.empty()) {
    CUTIS_TRY(given, wholeNumber("--people", command.people, kFewestPeople, kMostPeople));
    people = given;
  }
  if (!command.plot.empty()) CUTIS_CHECK(checkDrawingOutput(command.plot));
  CUTIS_TRY(model, session.engine.model(command.profile, "--profile"));
  CUTIS_TRY(rig, loadRig(command.rig, {}, "--rig"));
  if (!command.noise.empty()) {
    CUTIS_TRY(noise, realNumbers("--noise", command.noise, 2, 0.0, 1.0));
    rig.noise = {noise[0], noise[1]};
    if (rig.noise.isExact()) {
      return usageError("--noise", "without noise everything is known; give one above 0");
    }
  }
  Prior prior = model->profile().prior;
  if (!command.prior.empty()) {
    CUTIS_TRY(given, readPrior(command.prior, prior));
    prior = given;
  }
  CUTIS_TRY(figures, identifyRig(*model, rig, prior, static_cast<std::size_t>(people),
                                 session.context.child(0.0, 1.0, "identifying")));
  if (!command.plot.empty()) CUTIS_CHECK(writeRigPlot(command.plot, figures));
  session.clearProgress();
  const std::string text = rigTables(figures);
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) {
    return {};
  }
  return resourceError("standard output", "the tables could not be written");
}

}  // namespace

void addRigCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<RigCommand>();
  CLI::App& command =
      addCommand(app, invocation, "rig", "What a rig can tell apart", options, runRigCommand);
  command
      .add_option("ACTION", options->action,
                  "identify: what the channels leave open of each parameter, which light to add, "
                  "and what noise does")
      ->required()
      ->type_name("");
  command.add_option("--rig", options->rig, "A built-in name or a JSON file (default: monitor)")
      ->type_name("NAME|FILE");
  command
      .add_option("--profile", options->profile,
                  "Skin model: a built-in name or a JSON file (default: skin2026)")
      ->type_name("NAME|FILE");
  command
      .add_option("--prior", options->prior,
                  "JSON file with what is known of the skin beforehand (default: the profile's)")
      ->type_name("FILE");
  command
      .add_option("--noise", options->noise,
                  "Standard deviations of a channel, constant and proportional (default: the "
                  "rig's)")
      ->type_name("READ,PROP");
  command.add_option("--people", options->people, "People to draw from the prior (default: 500)")
      ->type_name("N");
  command.add_option("--plot", options->plot, "Picture to write, .svg or .png")->type_name("FILE");
}

}  // namespace cutis
