#include "src/cli/commands/fit_source.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/analyse/exposure.h"
#include "core/fit/free/free_solver.h"
#include "core/rig/surface_reflection.h"
#include "src/files/io/csv.h"
#include "src/files/profiles/profile_file.h"
#include "src/images/capture/capture_file.h"

namespace cutis {
namespace {

using ProgressClock = std::chrono::steady_clock;

// Seconds since the last call.
class Lap {
 public:
  double seconds() {
    const auto now = ProgressClock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

 private:
  ProgressClock::time_point start_ = ProgressClock::now();
};

Status setBestExposure(const std::string& path, const SourceOptions& options,
                       const PixelSolver& solver, const Session& session, FittedSource& fitted) {
  // Too short to be shown.
  const JobContext silent = {session.context.stop, {}, session.context.notice};
  CUTIS_TRY(choice, chooseExposure(fitted.source.measurements, solver, silent));
  session.context.say(path + ": exposure " + formatNumber(choice.exposure, 4) + " brings " +
                      formatNumber(100.0 * choice.inside, 3) +
                      " % of the pixels into the profile's range of skin colours");
  if (choice.exposure == 1.0) return {};
  // Read anew, so that the same number given by hand makes the same maps.
  SourceOptions exposed = options;
  exposed.exposure = choice.exposure;
  fitted.source = Source();
  CUTIS_TRY(source, openSource(path, exposed, *fitted.model, session.store, silent));
  fitted.source = std::move(source);
  return {};
}

// The exact setting bends the parameters to whatever is in the channels.
void warnOfNoise(const std::string& path, const FitOptions& options, const FittedSource& fitted,
                 const JobContext& context) {
  constexpr double kExactResidual = 2e-4;
  const NoiseModel noise = options.noise.value_or(fitted.source.measurements.rig.noise);
  if (options.method != FitMethod::refined || !noise.isExact()) return;
  if (!(fitted.statistics.meanResidual > kExactResidual)) return;
  context.say(path + ": no skin meets these channels exactly (residual " +
              formatNumber(fitted.statistics.meanResidual, 2) +
              " on average), and without noise all of that goes into the maps; tell the noise, "
              "such as --noise 0.0001,0.005");
}

// What the channels do not tell is what was assumed.
void warnOfAssumptions(const std::string& path, const FittedSource& fitted,
                       const JobContext& context) {
  for (const ConstantSummary& summary : fitted.constants) {
    if (summary.openShare <= kMostlyAssumed) continue;
    context.say(path + ": " + std::string(constantName(summary.constant)) +
                " is mostly what was assumed: these channels leave " +
                formatNumber(100.0 * summary.openShare, 2) +
                " % of its uncertainty; photograph under more lights, or leave it out of --free");
  }
}

}  // namespace

Result<FittedSource> fitSource(const std::string& path, const FitRequest& request,
                               const Session& session, double share) {
  const JobContext context = session.context.child(0.0, share);
  if (request.chooseExposure && looksLikeCapture(path)) {
    return usageError("--exposure",
                      "a capture is linear and calibrated; this is for single images");
  }
  FittedSource fitted;
  Engine& engine = session.engine;
  CUTIS_TRY(model, engine.model(request.profile, "--profile"));
  fitted.model = model;
  FitOptions options = request.options;
  CUTIS_CHECK(completeFitOptions(request, model->profile(), options));

  Lap lap;
  SourceOptions sourceOptions = request.source;
  sourceOptions.surface = geometryOf(request.measurement, model->profile());
  if (options.noise) options.noise = noiseBelowSurface(*options.noise, sourceOptions.surface);
  CUTIS_TRY(source, openSource(path, sourceOptions, *model, session.store,
                               context.child(0.0, 0.15, "reading")));
  fitted.source = std::move(source);
  fitted.seconds.load = lap.seconds();
  if (options.free.count() > 0) {
    CUTIS_CHECK(checkChannelsDecide(fitted.source.measurements.rig, options, "--free"));
  }
  CUTIS_TRY(solver, engine.solver(model, fitted.source.measurements.rig, options,
                                  context.child(0.15, 0.25, "preparing")));
  fitted.nodes = solver->nodeCount();
  fitted.nodeRms = solver->nodes().rmsError;
  fitted.nodeWorst = solver->nodes().worstError;
  if (request.chooseExposure) {
    CUTIS_CHECK(setBestExposure(path, request.source, *solver, session, fitted));
  }
  fitted.seconds.prepare = lap.seconds();
  fitted.planes = FitPlanes(fitted.source.measurements, options, session.store);
  CUTIS_TRY(statistics,
            runFit(fitted.source.measurements, *solver, fitted.planes, context.child(0.25, 1.0)));
  fitted.statistics = statistics;
  CUTIS_TRY(gamut, measureGamut(fitted.source.measurements, fitted.planes.maps, *solver,
                                options.noise, context.child(1.0, 1.0)));
  fitted.gamut = gamut;
  CUTIS_TRY(constants, summariseConstants(fitted.source.measurements, fitted.planes.maps, *solver,
                                          model->profile(), context.child(1.0, 1.0)));
  fitted.constants = std::move(constants);
  warnOfAssumptions(path, fitted, context);
  warnOfNoise(path, options, fitted, context);
  fitted.seconds.fit = lap.seconds();
  return fitted;
}

Result<MapsFile> mapsFileOf(const FittedSource& fitted, const FitRequest& request) {
  MapsFile file;
  file.maps = fitted.planes.maps;
  const auto& deviations = fitted.planes.deviations;
  const auto ofParameters = std::min<std::size_t>(deviations.size(), kParameterCount);
  const auto split = deviations.begin() + static_cast<std::ptrdiff_t>(ofParameters);
  file.deviations.assign(deviations.begin(), split);
  file.constantDeviations.assign(split, deviations.end());
  file.residuals = fitted.planes.residuals;
  file.shading = fitted.planes.shading;
  const Rig& rig = fitted.source.measurements.rig;
  for (std::size_t k = 0; k < file.residuals.size(); ++k) {
    file.residualNames.push_back(rig.channelName(static_cast<int>(k)));
  }
  CUTIS_TRY(profileJson, profileText(request.profile, "--profile"));
  file.attributes = {fitted.model->profile().name,
                     profileJson,
                     rig.name,
                     request.methodName,
                     fitted.source.surface.specularShare,
                     fitted.source.exposure,
                     fitted.source.references,
                     fitted.source.colorSpace};
  file.metadata = fitted.source.metadata;
  return file;
}

}  // namespace cutis
