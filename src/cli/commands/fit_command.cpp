// fit: photographs or a texture to chromophore maps.

#include <chrono>

#include "src/app/export/export.h"
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
  FitCommandOptions fit;
};

ExportTarget targetOf(const FitCommand& command, const FitRequest& request) {
  return {
      .path = command.output, .inputs = filesRead(request), .sources = {command.sources.front()}};
}

Status checkFitOutputs(const FitCommand& command, const ExportTarget& target) {
  CUTIS_CHECK(checkMapsTarget(target));
  if (command.report.empty()) return {};
  CUTIS_CHECK(checkDistinct(command.report, command.output));
  CUTIS_CHECK(checkNotInput(command.report, target.sources));
  return checkTextOutput(command.report, target.inputs);
}

Result<FitRequest> requestOf(const FitCommand& command) {
  if (command.sources.size() > 1) {
    return usageError(command.sources[1],
                      "several images are not in this version; fit one at a time");
  }
  CUTIS_TRY(request, parseFitOptions(command.fit));
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
  const ExportTarget target = targetOf(command, request);
  CUTIS_CHECK(checkFitOutputs(command, target));
  CUTIS_TRY(result, openAndFit(command.sources.front(), request, session, 0.9));
  FittedSource& fitted = result.fitted;
  const auto start = std::chrono::steady_clock::now();
  CUTIS_CHECK(exportTo(target, mapsFileOf(fitted, result.profileJson), session.engine,
                       session.store, session.context.child(0.9, 1.0)));
  fitted.seconds.write =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (command.report.empty()) return {};
  return writeFitReport(command.report, fitted);
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
  addFitOptions(command, options->fit);
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
