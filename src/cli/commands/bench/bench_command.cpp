// bench: the error protocol, and time and memory of whole pictures.

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "core/base/instruction_set.h"
#include "core/base/parallel.h"
#include "src/bench/discrepancy_study.h"
#include "src/bench/error_study.h"
#include "src/bench/network_study.h"
#include "src/bench/picture_study.h"
#include "src/bench/start_study.h"
#include "src/bench/variant_study.h"
#include "src/cli/command.h"
#include "src/cli/commands/bench/bench_plot.h"
#include "src/cli/commands/bench/bench_report.h"
#include "src/cli/commands/bench/bench_table.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/option_values.h"
#include "src/cli/output_check.h"
#include "src/cli/standard_output.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/rig_file.h"
#include "src/files/system/platform.h"
#include "src/report/picture_file.h"

namespace cutis {
namespace {

constexpr char kRig[] = "monitor";
constexpr int kFewestPixels = 100;
constexpr int kMostPixels = 1000000;
constexpr std::size_t kSubsample = 2000;

struct BenchCommand {
  bool quick = false;
  std::string pixels;
  std::string profile;
  std::string report;
  std::string plot;
};

// How much is run.
struct Extent {
  int pixels;
  std::size_t subsample;
  double timingSeconds;
  PictureSeries pictures;
  NetworkSeries networks;
};

Extent extentOf(bool quick) {
  if (quick) return {4000, 400, 0.1, {{512, 1024}, 512, 1024}, {1024, false}};
  return {20000, kSubsample, 0.5, {{512, 1024, 2048, 4096}, 2048, 2048}, {2048, true}};
}

Status checkOutputs(const BenchCommand& command) {
  CUTIS_CHECK(checkDistinct(command.plot, command.report));
  if (!command.report.empty()) CUTIS_CHECK(checkTextOutput(command.report, {command.profile}));
  if (command.plot.empty()) return {};
  CUTIS_CHECK(checkNotInput(command.plot, {command.profile}));
  return checkDrawingOutput(command.plot);
}

Status print(const std::string& text, const Session& session) {
  session.clearProgress();
  return printText(text, kTablesLost);
}

// A part of the run, and what is printed once its figures are there.
struct Part {
  double until;  // share of the whole
  const char* name;
  std::function<Status(const JobContext&)> run;
  std::string (*tables)(const BenchFigures&);
};

std::vector<Part> partsOf(const BenchSubject& subject, const Extent& extent, MethodSolvers& solvers,
                          const JobContext& whole, BenchFigures& figures) {
  const PictureSeries& pictures = extent.pictures;
  const JobContext silent = {whole.stop, {}, {}};
  return {
      {0.02, "bounds",
       [&, silent](const JobContext&) { return runBounds(subject, silent, figures); }, boundTables},
      {0.12, "networks",
       [&, networks = extent.networks](const JobContext& context) {
         return runNetworks(subject, networks, solvers, context, figures);
       },
       networkTable},
      {0.45, "errors",
       [&](const JobContext& context) { return runMethods(subject, solvers, context, figures); },
       methodTables},
      {0.52, "errors on the sample",
       [&](const JobContext& context) { return runSample(subject, solvers, context, figures); },
       sampleTable},
      {0.53, "what the model leaves over",
       [&, silent](const JobContext&) { return runDiscrepancy(subject, silent, figures); },
       discrepancyTable},
      {0.54, "coverage",
       [&, silent](const JobContext&) { return runCoverage(subject, solvers, silent, figures); },
       coverageTables},
      {0.57, "lights",
       [&, silent](const JobContext&) { return runLights(subject, silent, figures); }, lightTable},
      {0.59, "parameters",
       [&, silent](const JobContext&) { return runParameters(subject, solvers, silent, figures); },
       parameterTable},
      {0.60, "starts",
       [&, silent](const JobContext&) { return runStarts(subject, solvers, silent, figures); },
       startTable},
      {0.61, "kinds of input",
       [&, silent](const JobContext&) { return runEncodings(subject, solvers, silent, figures); },
       encodingTable},
      {0.94, "pictures by size",
       [&, pictures](const JobContext& context) {
         return runSizes(subject, pictures, solvers, context, figures);
       },
       sizeTable},
      {1.0, "pictures by threads",
       [&, pictures](const JobContext& context) {
         return runScaling(subject, pictures, solvers, context, figures);
       },
       scalingTable},
  };
}

Status runBenchCommand(const BenchCommand& command, Session& session) {
  Extent extent = extentOf(command.quick);
  if (!command.pixels.empty()) {
    CUTIS_TRY(pixels, wholeNumber("--pixels", command.pixels, kFewestPixels, kMostPixels));
    extent.pixels = pixels;
  }
  CUTIS_CHECK(checkOutputs(command));
  const std::string profile = command.profile.empty() ? kPaperProfile : command.profile;
  CUTIS_TRY(model, session.engine.model(profile, "--profile"));
  CUTIS_CHECK(checkHoldsProtocol(model->profile()));
  CUTIS_TRY(rig, loadRig(kRig, {}, "--rig"));
  CUTIS_TRY(meter, protocolMeter(*model));
  const auto pixels = static_cast<std::size_t>(extent.pixels);
  const BenchSubject subject = {session.engine,
                                session.store,
                                model,
                                rig,
                                meter,
                                pixels,
                                std::min(pixels, extent.subsample),
                                extent.timingSeconds};

  BenchFigures figures;
  figures.version = CUTIS_VERSION;
  figures.processor = processorName();
  figures.instructionSet = instructionSetName();
  figures.threads = parallelThreadCount();
  figures.profile = model->profile().name;
  figures.rig = rig.name;
  figures.pixels = subject.pixels;
  figures.subsample = subject.subsample;
  figures.quick = command.quick;
  MethodSolvers solvers(session.engine, model, rig, session.context);
  CUTIS_CHECK(print(benchHeader(figures), session));
  double from = 0.0;
  for (const Part& part : partsOf(subject, extent, solvers, session.context, figures)) {
    const JobContext context = session.context.child(from, part.until, part.name);
    context.progress.report(0.0);
    CUTIS_CHECK(part.run(context));
    CUTIS_CHECK(print(part.tables(figures), session));
    from = part.until;
  }
  CUTIS_CHECK(print(goalTable(figures), session));
  if (!command.report.empty()) CUTIS_CHECK(writeBenchReport(command.report, figures));
  if (!command.plot.empty()) CUTIS_CHECK(writeDrawing(command.plot, benchPlot(figures)));
  return {};
}

}  // namespace

void addBenchCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<BenchCommand>();
  CLI::App& command =
      addCommand(app, invocation, "bench",
                 "Errors and speed of all methods on simulated skin of a monitor rig", options,
                 runBenchCommand);
  command.add_flag("--quick", options->quick,
                   "Fewer pixels and smaller pictures: less than a minute on two cores");
  addOption(command, "--pixels", options->pixels, "N",
            "Pixels to judge errors by, from 100 (default: 20000, quick: 4000); at most 2000 "
            "of them, quick: 400, for the exhaustive searches");
  addProfileOption(command, options->profile, kPaperProfile);
  addOption(command, "--report", options->report, "FILE", "JSON file to write with all figures");
  addOption(command, "--plot", options->plot, "FILE.svg|FILE.png",
            "Picture to write of run time against error, with the paper's figures, and of time and "
            "memory against pixels and threads: SVG or PNG, by the name's ending");
}

}  // namespace cutis
