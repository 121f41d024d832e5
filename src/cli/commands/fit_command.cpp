// fit: photographs or a texture to chromophore maps.

#include <chrono>

#include "src/cli/command.h"
#include "src/cli/commands/fit_report.h"
#include "src/cli/commands/fit_source.h"
#include "src/cli/output_check.h"

namespace cutis {
namespace {

struct FitCommand {
  std::vector<std::string> sources;
  std::string output;
  std::string report;
  std::string mask;
  std::string colorSpace;
  bool deviations = false;
  FitArguments fit;
};

Status checkFitOutputs(const FitCommand& command, const FitRequest& request) {
  CUTIS_TRY(inputs, inputFiles(command.sources.front()));
  for (const std::string& file : filesRead(request))
    inputs.push_back(file);
  CUTIS_CHECK(checkMapsOutput(command.output, inputs));
  if (command.report.empty()) return {};
  CUTIS_CHECK(checkDistinct(command.report, command.output));
  return checkTextOutput(command.report, inputs);
}

Result<FitRequest> requestOf(const FitCommand& command) {
  if (command.sources.size() > 1) {
    return usageError(command.sources[1],
                      "several images are not in this version; fit one at a time");
  }
  CUTIS_TRY(request, parseFitArguments(command.fit));
  request.source.mask = command.mask;
  request.source.colorSpace = command.colorSpace;
  if (command.deviations && request.options.method != FitMethod::refined) {
    return usageError("--deviation", "only the method refined knows deviations; leave it out");
  }
  request.options.deviations = command.deviations;
  request.options.residuals = command.deviations;
  return request;
}

Status runFitCommand(const FitCommand& command, Session& session) {
  CUTIS_TRY(request, requestOf(command));
  CUTIS_CHECK(checkFitOutputs(command, request));
  CUTIS_TRY(fitted, fitSource(command.sources.front(), request, session, 0.9));
  CUTIS_TRY(file, mapsFileOf(fitted, request));
  const auto start = std::chrono::steady_clock::now();
  CUTIS_CHECK(writeMaps(command.output, file, session.context.child(0.9, 1.0, "writing")));
  fitted.seconds.write =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (command.report.empty()) return {};
  return writeFitReport(command.report, fitted, request.methodName);
}

}  // namespace

void addFitCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<FitCommand>();
  CLI::App& command =
      addCommand(app, invocation, "fit", "Fit chromophore maps to a capture or an albedo texture",
                 options, runFitCommand);
  command
      .add_option("SOURCE", options->sources, "Folder or capture.json of a capture, or an image")
      ->required()
      ->type_name("");
  command.add_option("-o,--output", options->output, "Maps to write, an OpenEXR file (.exr)")
      ->required()
      ->type_name("MAPS");
  addFitArguments(command, options->fit);
  command
      .add_option("--mask", options->mask,
                  "Image of the source's size: 0 leaves a pixel out, anything else includes it "
                  "(default: the capture's own, if any)")
      ->type_name("FILE");
  command
      .add_option("--colorspace", options->colorSpace,
                  "Colour space of an image (default: what the file says, else sRGB for "
                  "integers and Linear Rec.709 for floats)")
      ->type_name("NAME");
  command.add_flag("--deviation", options->deviations,
                   "Write posterior standard deviations and residuals beside the maps");
  command
      .add_option("--report", options->report, "JSON file to write with counts, timings and errors")
      ->type_name("FILE");
}

}  // namespace cutis
