#pragma once

// The commands of the program, one file each: <name>_command.cpp. A command adds its options to the
// command line and leaves behind what is to be done; nothing happens before the whole line was
// read.

#include <functional>
#include <memory>

#include <CLI/App.hpp>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/base/tile_store.h"
#include "src/app/engine.h"
#include "src/cli/options/common_options.h"

namespace cutis {

// What a command works with.
struct Session {
  Engine& engine;
  std::shared_ptr<TileStore> store;
  JobContext context;
  bool quiet = false;
  // Takes the line of progress off the terminal, before something is printed there.
  std::function<void()> clearProgress;
};

struct Invocation {
  CommonOptions common;
  std::function<Status(Session&)> run;
};

// Adds a command whose options live as long as the command line. `run` is called with them.
template <typename Options>
CLI::App& addCommand(CLI::App& app, Invocation& invocation, const char* name, const char* purpose,
                     const std::shared_ptr<Options>& options,
                     Status (*run)(const Options&, Session&)) {
  CLI::App& command = *app.add_subcommand(name, purpose);
  addCommonOptions(command, invocation.common);
  command.callback([&invocation, options, run] {
    invocation.run = [options, run](Session& session) { return run(*options, session); };
  });
  return command;
}

void addFitCommand(CLI::App& app, Invocation& invocation);
void addFitSpectraCommand(CLI::App& app, Invocation& invocation);
void addEditCommand(CLI::App& app, Invocation& invocation);
void addRenderCommand(CLI::App& app, Invocation& invocation);
void addApplyCommand(CLI::App& app, Invocation& invocation);
void addSpectrumCommand(CLI::App& app, Invocation& invocation);
void addSimulateCommand(CLI::App& app, Invocation& invocation);
void addValidateCommand(CLI::App& app, Invocation& invocation);
void addCalibrateProfileCommand(CLI::App& app, Invocation& invocation);
void addTrainCommand(CLI::App& app, Invocation& invocation);
void addRigCommand(CLI::App& app, Invocation& invocation);
void addBenchCommand(CLI::App& app, Invocation& invocation);
void addInfoCommand(CLI::App& app, Invocation& invocation);

}  // namespace cutis
