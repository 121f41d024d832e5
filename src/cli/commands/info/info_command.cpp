// info: what a file is, or what the program has and runs on.

#include "src/cli/command.h"
#include "src/cli/commands/info/info_file.h"
#include "src/cli/commands/info/info_system.h"
#include "src/cli/options/add_option.h"
#include "src/cli/standard_output.h"

namespace cutis {
namespace {

struct InfoCommand {
  std::string file;
  std::string layer;
  bool system = false;
};

Status runInfoCommand(const InfoCommand& command, Session& session) {
  if (command.system != command.file.empty()) {
    return usageError("info", "name a file or give --system, and not both");
  }
  if (command.system && !command.layer.empty()) {
    return usageError("--layer", "this chooses a layer of a file; leave it out");
  }
  std::string text = describeSystem();
  if (!command.system) {
    CUTIS_TRY(description, describeFile(command.file, command.layer, session));
    text = description;
  }
  return printText(text, kOutputLost);
}

}  // namespace

void addInfoCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<InfoCommand>();
  CLI::App& command =
      addCommand(app, invocation, "info", "What a file is, or what this program has and runs on",
                 options, runInfoCommand);
  addOption(command, "FILE", options->file, "",
            "Image, maps, capture, project, rig, profile, recipe or cached table");
  addOption(command, "--layer", options->layer, "NAME", "Layer or part of an OpenEXR image");
  command.add_flag("--system", options->system,
                   "Version, machine, and the built-in profiles, rigs, lights, observers and "
                   "cameras");
}

}  // namespace cutis
