#include "src/cli/program.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <stop_token>
#include <string>
#include <system_error>
#include <vector>

#include <tbb/global_control.h>

#include "core/base/choice_place.h"
#include "core/base/instruction_set.h"
#include "src/cli/command.h"
#include "src/cli/command_line.h"
#include "src/cli/console.h"
#include "src/cli/help_format.h"
#include "src/cli/options/train_options.h"
#include "src/files/system/interruption.h"
#include "src/files/system/last_words.h"
#include "src/files/system/platform.h"

namespace cutis {
namespace {

constexpr int kInterrupted = 130;
constexpr int kNoMemoryStatus = 4;
constexpr std::size_t kPictureMemoryBytes = std::size_t{2} << 30;

constexpr char kPurpose[] =
    "Chromophore maps of human skin: fit them to photographs, edit them, render them.\n"
    "A CAPTURE is a folder with capture.json; a single IMAGE is an albedo texture.";
constexpr char kFooter[] =
    "Exit status: 0 done, 2 wrong usage, 3 bad input, 4 no memory, disk or permission,\n"
    "130 interrupted. 'cutis-cli COMMAND --help' lists all options of a command.";

std::stop_source& interruption() {
  // Never destroyed: a signal may come while the program ends.
  static auto& source = *new std::stop_source;
  return source;
}

int exitStatus(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return 2;
    case ErrorKind::input:
      return 3;
    case ErrorKind::resource:
      return 4;
  }
  return 4;
}

std::unique_ptr<CLI::App> makeCommandLine(Invocation& invocation) {
  auto app = std::make_unique<CLI::App>(kPurpose, "cutis-cli");
  app->formatter(std::make_shared<HelpFormat>());
  app->set_version_flag("--version", "cutis-cli " CUTIS_VERSION, "Print the version and exit");
  // Commands take over the formatter and the help of the program they are added to.
  app->set_help_flag("-h,--help", "Print this help and exit");
  app->footer(kFooter);
  app->require_subcommand(1);
  for (const auto add :
       {addFitCommand, addEditCommand, addRenderCommand, addApplyCommand, addSpectrumCommand,
        addFitSpectraCommand, addSimulateCommand, addValidateCommand, addCalibrateProfileCommand,
        addTrainCommand, addRigCommand, addBenchCommand, addInfoCommand}) {
    add(*app, invocation);
  }
  return app;
}

// What the command line asks for; nothing if it was help or the version, which are printed.
Result<std::optional<Invocation>> readCommandLine(int argc, const char* const* argv) {
  Invocation invocation;
  const auto app = makeCommandLine(invocation);
  CUTIS_CHECK(
      checkCommandLine(*app, std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc)));
  try {
    app->parse(argc, argv);
  } catch (const CLI::Success& request) {
    app->exit(request);
    return std::optional<Invocation>();
  } catch (const CLI::ParseError& error) {
    return usageErrorOf(*app, error);
  }
  return std::optional<Invocation>(invocation);
}

Status run(const Invocation& invocation, Console& console) {
  const char* isa = std::getenv("CUTIS_ISA");
  CUTIS_CHECK(pinInstructionSet(isa == nullptr ? "" : isa));
  CUTIS_TRY(threads, threadCount(invocation.common));
  std::optional<tbb::global_control> limit;
  if (threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  Engine engine(cacheFolder(), networkAdvice());
  Session session = {engine,
                     std::make_shared<TileStore>(kPictureMemoryBytes),
                     {},
                     invocation.common.quiet,
                     [&console] { console.clear(); }};
  session.context.stop = interruption().get_token();
  session.context.progress = Progress(
      [&console](double fraction, const std::string& stage) { console.progress(fraction, stage); });
  session.context.notice = [&console](const std::string& sentence) { console.note(sentence); };
  return invocation.run(session);
}

// What was chosen is chosen by options here.
std::string optionAt(const std::string& place) {
  constexpr std::array<std::pair<const char*, const char*>, 6> kOptions = {
      {{kColorSpaceChoice, "--colorspace"},
       {kExposureChoice, "--exposure"},
       {kLayerChoice, "--layer"},
       {kLightsChoice, "--lights"},
       {kRigChoice, "--rig"},
       {kSurfaceChoice, "--specular"}}};
  for (const auto& [choice, option] : kOptions) {
    if (place == choice) return option;
  }
  return place;
}

int report(const Failure& failure, Console& console) {
  if (const auto* error = std::get_if<Error>(&failure)) {
    console.error(Error{error->kind, optionAt(error->place), error->message}.text());
    return exitStatus(error->kind);
  }
  console.error("interrupted");
  return kInterrupted;
}

// What libraries throw in spite of all is an error like any other.
Status readAndRun(int argc, const char* const* argv, Console& console) try {
  CUTIS_CHECK(onInterrupt([] { interruption().request_stop(); }));
  CUTIS_TRY(invocation, readCommandLine(argc, argv));
  if (!invocation) return {};
  console.setQuiet(invocation->common.quiet);
  return run(*invocation, console);
} catch (const std::bad_alloc&) {
  return resourceError("", kNoMemory);
} catch (const std::system_error& error) {
  return resourceError("", error.code() == std::errc::resource_unavailable_try_again
                               ? std::string(kNoMemory)
                               : std::string(error.what()));
} catch (const std::exception& error) {
  return resourceError("", error.what());
}

}  // namespace

int runProgram(int argc, const char* const* argv) try {
  Console console;
  const Status status = readAndRun(argc, argv, console);
  console.clear();
  return status ? 0 : report(status.failure(), console);
} catch (const std::exception&) {
  // Not even the sentence could be put together.
  sayLastWords(kNoMemory);
  return kNoMemoryStatus;
}

}  // namespace cutis
