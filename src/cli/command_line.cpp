#include "src/cli/command_line.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "core/base/echoed_text.h"
#include "src/files/io/suggestion.h"

namespace cutis {
namespace {

constexpr std::array<std::string_view, 2> kLaterCommands = {"measure", "export"};

struct LaterOption {
  std::string_view command;
  std::string_view option;
};
constexpr std::array<LaterOption, 2> kLaterOptions = {
    {{"fit", "--frames"}, {"render", "--scatter"}}};

std::vector<const CLI::App*> commandsOf(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> optionNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
    for (const std::string& name : option->get_snames())
      names.push_back("-" + name);
  }
  return names;
}

// "--rig=monitor" → "--rig", "-oOUT" → "-o"; empty for what is no option.
std::string optionName(const std::string& argument) {
  if (argument.size() < 2 || argument[0] != '-') return {};
  if (argument[1] == '-') return argument.substr(0, argument.find('='));
  if (std::isdigit(static_cast<unsigned char>(argument[1])) != 0 || argument[1] == '.') return {};
  return argument.substr(0, 2);
}

bool isLater(const std::string& command, const std::string& option) {
  return std::any_of(kLaterOptions.begin(), kLaterOptions.end(), [&](const LaterOption& later) {
    return later.command == command && later.option == option;
  });
}

Status checkCommand(const CLI::App& app, const std::string& name) {
  if (std::find(kLaterCommands.begin(), kLaterCommands.end(), name) != kLaterCommands.end()) {
    return usageError(name, kNotInThisVersion);
  }
  std::vector<std::string> known;
  for (const CLI::App* command : commandsOf(app))
    known.push_back(command->get_name());
  if (std::find(known.begin(), known.end(), name) != known.end()) return {};
  return usageError("", "unknown command " + inQuotes(name) + "; " + suggestName(name, known));
}

Status checkOption(const CLI::App& command, const std::string& name) {
  const std::vector<std::string> known = optionNames(command);
  if (std::find(known.begin(), known.end(), name) != known.end()) return {};
  if (isLater(command.get_name(), name)) return usageError(name, kNotInThisVersion);
  return usageError(shortened(name), "unknown option; " + suggestName(name, known));
}

}  // namespace

Status checkCommandLine(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty()) return usageError("", "name a command; cutis-cli --help lists them");
  const CLI::App* command = &app;
  for (const std::string& argument : words) {
    if (argument == "--") break;
    const std::string name = optionName(argument);
    if (!name.empty()) {
      CUTIS_CHECK(checkOption(*command, name));
    } else if (command == &app) {
      CUTIS_CHECK(checkCommand(app, argument));
      command = app.get_subcommand(argument);
    }
  }
  return {};
}

Error usageErrorOf(const CLI::App& app, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const std::string name = chosen.empty() ? std::string() : chosen.front()->get_name();
  const std::string help = "see cutis-cli " + (name.empty() ? "" : name + " ") + "--help";
  // "SOURCE is required", "--rig: 1 required TEXT missing", "The following argument was not …"
  return usageError(name, shortened(error.what()) + "; " + help);
}

}  // namespace cutis
