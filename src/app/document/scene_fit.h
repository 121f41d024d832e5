#pragma once

// One fit of a scene's source, so that what is done can be looked at before the rest is.

#include <functional>
#include <memory>

#include "core/base/job_context.h"
#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/fit/fit_run.h"
#include "src/app/document/scene.h"
#include "src/app/engine.h"
#include "src/app/open/fit_choice.h"

namespace cutis {

struct SceneFitObserver {
  // The scene with new maps that hold a first impression; they fill from now on. From the thread
  // that fits.
  std::function<void(const Scene& scene)> begun;
  // More of the maps is final. From any thread.
  std::function<void()> changed;
  // What somebody looks at now, in pixels. From any thread.
  std::function<Rect()> view;
};

// Precondition: the scene has a source and the model of the choice's profile. Its maps are left as
// they are; those of the fit are new. Cancelled if asked to stop. Errors: those of
// Engine::solver().
Result<FitStatistics> fitScene(Scene scene, const FitChoice& choice, Engine& engine,
                               const std::shared_ptr<TileStore>& store, const JobContext& context,
                               const SceneFitObserver& observer);

}  // namespace cutis
