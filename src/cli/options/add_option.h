#pragma once

// How commands declare options that take a value.

#include <string>

#include <CLI/App.hpp>

namespace cutis {

// name: "--rig", "-o,--output", or "SOURCE" for what stands without a name. type: what the help
// shows for the value, "NAME|FILE"; may be empty. A value that is not given stays as it is.
template <typename Value>
CLI::Option* addOption(CLI::App& command, const std::string& name, Value& value, const char* type,
                       const std::string& text) {
  return command.add_option(name, value, text)->type_name(type);
}

// --profile of what works with one skin model; usual: where the option is not given.
inline void addProfileOption(CLI::App& command, std::string& value, const std::string& usual) {
  addOption(command, "--profile", value, "NAME|FILE",
            "Skin model: a built-in name or a JSON file (default: " + usual + ")");
}

}  // namespace cutis
