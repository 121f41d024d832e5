// rig: what a rig can find out about skin.

#include "core/analyse/rig_study.h"
#include "core/base/echoed_text.h"
#include "src/cli/command.h"
#include "src/cli/command_line.h"
#include "src/cli/commands/rig/rig_identify.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/option_values.h"
#include "src/cli/output_check.h"
#include "src/cli/standard_output.h"
#include "src/files/profiles/prior_file.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/rig_file.h"
#include "src/files/spectral_library.h"
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
  return usageError("rig", "unknown action " + inQuotes(action) + "; it is identify");
}

// Diodes and all lights of the library.
Result<std::vector<RigLight>> candidateLights() {
  std::vector<RigLight> lights = narrowLights();
  for (const std::string& name : lightNames()) {
    CUTIS_TRY(power, loadLight({name, {}, {}}));
    lights.push_back({name, power, {}});
  }
  return lights;
}

Status runRigCommand(const RigCommand& command, Session& session) {
  CUTIS_CHECK(checkAction(command.action));
  int people = kUsualPeople;
  if (!command.people.empty()) {
    CUTIS_TRY(given, wholeNumber("--people", command.people, kFewestPeople, kMostPeople));
    people = given;
  }
  if (!command.plot.empty()) {
    CUTIS_CHECK(checkNotInput(command.plot, {command.rig, command.profile, command.prior}));
    CUTIS_CHECK(checkDrawingOutput(command.plot));
  }
  CUTIS_TRY(model, session.engine.model(command.profile, "--profile"));
  CUTIS_TRY(rig, loadRig(command.rig, {}, "--rig", session.context.notice));
  if (!command.noise.empty()) {
    CUTIS_TRY(noise, realNumbers("--noise", command.noise, 2, 0.0, 1.0));
    rig.noise = {noise[0], noise[1]};
    if (rig.noise.isExact()) {
      return usageError("--noise", "without noise everything is known; give a noise above 0");
    }
  }
  Prior prior = model->profile().prior;
  if (!command.prior.empty()) {
    CUTIS_TRY(given, readPrior(command.prior, prior));
    prior = given;
  }
  CUTIS_TRY(candidates, candidateLights());
  CUTIS_TRY(study, studyRig(*model, rig, prior, static_cast<std::size_t>(people), candidates,
                            session.context.child(0.0, 1.0, "identifying")));
  const RigFigures figures =
      namedFigures(study, rig.name, model->profile().name, static_cast<std::size_t>(people));
  if (!command.plot.empty()) CUTIS_CHECK(writeRigPlot(command.plot, figures));
  session.clearProgress();
  return printText(rigTables(figures), kTablesLost);
}

}  // namespace

void addRigCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<RigCommand>();
  CLI::App& command =
      addCommand(app, invocation, "rig", "What a rig can tell apart", options, runRigCommand);
  addOption(command, "ACTION", options->action, "",
            "identify: what the channels leave open of each parameter, which light to add, "
            "and what noise does")
      ->required();
  addOption(command, "--rig", options->rig, "NAME|FILE",
            "A built-in name or a JSON file (default: monitor)");
  addProfileOption(command, options->profile, kDefaultProfile);
  addOption(command, "--prior", options->prior, "FILE",
            "JSON file with what is known of the skin beforehand (default: the profile's)");
  addOption(command, "--noise", options->noise, "READ,PROP",
            "Standard deviations of a channel, constant and proportional (default: the "
            "rig's)");
  addOption(command, "--people", options->people, "N",
            "People to draw from the prior (default: 500)");
  addOption(command, "--plot", options->plot, "FILE", "Picture to write, .svg or .png");
}

}  // namespace cutis
