#include "src/app/document/scene_fit.h"

#include "core/fit/coarse_fit.h"

namespace cutis {

Result<FitStatistics> fitScene(Scene scene, const FitChoice& choice, Engine& engine,
                               const std::shared_ptr<TileStore>& store, const JobContext& context,
                               const SceneFitObserver& observer) {
  const Measurements& measurements = scene.source->measurements;
  const FitOptions options = fitOptions(choice);
  CUTIS_TRY(solver, engine.solver(scene.model, measurements.rig, options,
                                  context.child(0.0, 0.1, "preparing")));
  const FitPlanes planes(measurements, options, store);
  scene.maps = planes.maps;
  CUTIS_CHECK(runCoarseFit(measurements, *solver, planes.maps,
                           context.child(0.1, 0.15, "first impression")));
  observer.begun(scene);
  FitObserver progress;
  progress.finished = [&observer](const Rect&) { observer.changed(); };
  progress.view = observer.view;
  return runFit(measurements, *solver, planes, context.child(0.15, 1.0, solver->stage()), progress);
}

}  // namespace cutis
