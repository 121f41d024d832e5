#include "src/app/open/source_fit.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/analyse/diffusion_domain.h"
#include "core/analyse/exposure.h"
#include "core/fit/coarse_fit.h"
#include "core/fit/discrepancy_choice.h"
#include "core/fit/fit_record.h"
#include "src/app/fit_method.h"
#include "src/files/profiles/fit_record_file.h"

namespace cutis {
namespace {

// Where the parts of the work end, as shares of the progress.
constexpr double kPrepared = 0.1;
constexpr double kExposed = 0.13;
constexpr double kShown = 0.15;

using Clock = std::chrono::steady_clock;

// Seconds since the last call.
class Lap {
 public:
  double seconds() {
    const auto now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

 private:
  Clock::time_point start_ = Clock::now();
};

std::shared_ptr<const Source> atExposure(const Source& source, double exposure) {
  auto exposed = std::make_shared<Source>(source);  // planes are handles
  exposed->measurements.exposure = exposure;
  return exposed;
}

// Fills the planes, after a first impression where somebody watches.
Result<FitStatistics> fill(const FittedSource& fitted,
                           const std::shared_ptr<const PixelSolver>& solver,
                           const JobContext& context, const SourceFitObserver& observer) {
  const Measurements& measurements = fitted.source->measurements;
  if (observer.begun) {
    CUTIS_CHECK(runCoarseFit(measurements, *solver, fitted.planes.maps,
                             context.child(kExposed, kShown, "first impression")));
    observer.begun(fitted.source, solver, fitted.planes.maps);
  }
  FitObserver progress;
  if (observer.changed) progress.finished = [&observer](const Rect&) { observer.changed(); };
  progress.view = observer.view;
  return runFit(measurements, *solver, fitted.planes, context.child(kShown, 1.0), progress);
}

// What the fit found, looked at as a whole.
Status analyse(const FitOptions& options, const PixelSolver& solver, const JobContext& context,
               FittedSource& fitted) {
  const Measurements& measurements = fitted.source->measurements;
  const ChromophoreMaps& maps = fitted.planes.maps;
  const JobContext silent = context.child(1.0, 1.0);
  CUTIS_TRY(pixels, judgePixels(measurements, maps, solver, options.noise, silent));
  fitted.gamut = gamutOf(pixels);
  fitted.pixels = std::move(pixels);
  CUTIS_TRY(constants,
            summariseConstants(measurements, maps, solver, fitted.model->profile(), silent));
  fitted.constants = std::move(constants);
  CUTIS_TRY(outside, shareOutsideDiffusion(maps, fitted.model->profile(), silent));
  fitted.outsideDiffusion = outside;
  fitted.remarks =
      remarksOn(fitted.statistics, fitted.constants, options.method,
                options.noise.value_or(measurements.rig.noise), outside, fitted.exposure);
  return {};
}

// Only the method refined has a posterior.
std::string recordText(const FittedSource& fitted) {
  if (fitted.options.method != FitMethod::refined) return {};
  return fitRecordText(
      fitRecord(fitted.model->profile(), fitted.source->measurements.rig, fitted.options));
}

}  // namespace

Result<FittedSource> fitSource(const std::shared_ptr<const SkinModel>& model,
                               const std::shared_ptr<const Source>& source,
                               const SourceFitOptions& options, Engine& engine,
                               const std::shared_ptr<TileStore>& store, const JobContext& context,
                               const SourceFitObserver& observer) {
  Lap lap;
  FittedSource fitted;
  fitted.model = model;
  fitted.source = source;
  fitted.options = suitedTo(source->measurements, options.fit);
  CUTIS_TRY(solver, engine.solver(model, source->measurements.rig, fitted.options,
                                  context.child(0.0, kPrepared, "preparing")));
  fitted.nodes = solver->nodeCount();
  fitted.nodeRms = solver->nodes().rmsError;
  fitted.nodeWorst = solver->nodes().worstError;
  if (options.chooseExposure && source->image) {
    CUTIS_TRY(choice, chooseExposure(source->measurements, *solver,
                                     context.child(kPrepared, kExposed, "exposure")));
    fitted.exposure = choice;
    fitted.source = atExposure(*source, choice.exposure);
  }
  fitted.seconds.prepare = lap.seconds();
  fitted.planes = FitPlanes(fitted.source->measurements, options.fit, store);
  fitted.planes.maps.addCoefficients(options.fit.surface, solver->coefficientCount(), store);
  CUTIS_TRY(statistics, fill(fitted, solver, context, observer));
  fitted.statistics = statistics;
  CUTIS_CHECK(analyse(options.fit, *solver, context, fitted));
  if (auto remark = remarkOnDiscrepancy(model->profile(), source->measurements, options.fit))
    fitted.remarks.push_back(*std::move(remark));
  fitted.seconds.fit = lap.seconds();
  return fitted;
}

MapsFile mapsFileOf(const FittedSource& fitted, const std::string& profileJson) {
  MapsFile file;
  file.maps = fitted.planes.maps;
  const auto& deviations = fitted.planes.deviations;
  const auto ofParameters = std::min<std::size_t>(deviations.size(), kParameterCount);
  const auto split = deviations.begin() + static_cast<std::ptrdiff_t>(ofParameters);
  file.deviations.assign(deviations.begin(), split);
  file.constantDeviations.assign(split, deviations.end());
  file.residuals = fitted.planes.residuals;
  file.shading = fitted.planes.shading;
  const Measurements& measurements = fitted.source->measurements;
  for (std::size_t k = 0; k < file.residuals.size(); ++k) {
    file.residualNames.push_back(measurements.rig.channelName(static_cast<int>(k)));
  }
  file.attributes = {fitted.model->profile().name,
                     profileJson,
                     measurements.rig.name,
                     fitMethodName(fitted.options.method),
                     fitted.source->surface.specularShare,
                     measurements.exposure,
                     fitted.source->references,
                     fitted.source->colors.followed.space.name,
                     recordText(fitted)};
  file.metadata = fitted.source->metadata;
  return file;
}

}  // namespace cutis
