#include "src/cli/commands/fit_source.h"

#include <chrono>
#include <memory>
#include <utility>

#include "core/fit/free/free_solver.h"
#include "core/rig/surface_reflection.h"
#include "src/files/profiles/profile_file.h"
#include "src/images/capture/capture_file.h"

namespace cutis {
namespace {

// Where reading ends, as a share of the progress.
constexpr double kRead = 0.15;

// The options that help, behind what is said in the window, too.
std::string optionFor(FitRemark::Kind kind) {
  switch (kind) {
    case FitRemark::Kind::mostlyAssumed:
      return ", or leave it out of --free";
    case FitRemark::Kind::outsideDiffusion:
      return std::string(", such as --profile ") + kDefaultProfile;
    case FitRemark::Kind::discrepancyOff:
      return "; --discrepancy on estimates it all the same";
    case FitRemark::Kind::inexact:
      return ", such as --noise 0.0001,0.005";
    default:
      return {};
  }
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Result<FittedPath> openAndFit(const std::string& path, const FitRequest& request,
                              const Session& session, double share) {
  const JobContext context = session.context.child(0.0, share);
  if (request.exposureIsGiven && looksLikeCapture(path)) {
    return usageError("--exposure",
                      "a capture is linear and calibrated; this is for single images");
  }
  CUTIS_TRY(profileJson, profileText(request.profile, "--profile"));
  CUTIS_TRY(model, session.engine.modelFromText(profileJson, request.profile));
  SourceFitOptions options = {request.options, request.chooseExposure};
  CUTIS_CHECK(completeFitOptions(request, model->profile(), options.fit));

  const auto start = std::chrono::steady_clock::now();
  SourceOptions sourceOptions = request.source;
  sourceOptions.surface = geometryOf(request.measurement, model->profile());
  if (options.fit.noise) {
    options.fit.noise = noiseBelowSurface(*options.fit.noise, sourceOptions.surface);
  }
  CUTIS_TRY(opened, openSource(path, sourceOptions, *model, session.store,
                               context.child(0.0, kRead, "reading")));
  const auto source = std::make_shared<const Source>(std::move(opened));
  const double load = secondsSince(start);
  if (options.fit.free.count() > 0) {
    CUTIS_CHECK(checkChannelsDecide(source->measurements.rig, options.fit, "--free"));
  }
  CUTIS_TRY(fitted, fitSource(model, source, options, session.engine, session.store,
                              context.child(kRead, 1.0)));
  fitted.seconds.load = load;
  for (const FitRemark& remark : fitted.remarks)
    session.context.say(path + ": " + remark.sentence + optionFor(remark.kind));
  return FittedPath{std::move(fitted), profileJson};
}

}  // namespace cutis
