#pragma once  // internal to src/app/document

// What the fit of a document can say of its pixels beside their values: how well skin explains
// them, and how sure the values are.
//
// Made when somebody first asks for it, and kept for the scene. Thread-safe.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/analyse/pixel_sample.h"
#include "core/base/job_context.h"
#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/fit/fit_options.h"
#include "core/fit/pixel_solver.h"
#include "core/skin/parameter_buffer.h"
#include "src/app/document/pixel_marks.h"
#include "src/app/engine.h"
#include "src/app/open/source.h"

namespace cutis {

class FitEvidence {
 public:
  // What the questions are answered with.
  struct Tools {
    std::shared_ptr<const PixelSolver> solver;
    Rig rig;
    std::optional<NoiseModel> noise;  // assumed instead of the rig's
    Prior prior;
    ParameterAxes axes;
  };

  // Of a fit of the source with these options. solver: that fits it; null: it is made when it is
  // needed.
  FitEvidence(std::shared_ptr<const SkinModel> model, std::shared_ptr<const Source> source,
              const FitOptions& options, std::shared_ptr<const PixelSolver> solver = nullptr);

  // About 0.2 s the first time where there is no solver. Errors: those of Engine::solver().
  // Cancelled if asked to stop.
  Result<std::shared_ptr<const Tools>> tools(Engine& engine, const JobContext& context);
  const Measurements& measurements() const { return source_->measurements; }
  bool hasDeviations() const { return options_.method == FitMethod::refined; }
  bool hasShading() const { return options_.shading.has_value(); }

 private:
  std::shared_ptr<const SkinModel> model_;
  std::shared_ptr<const Source> source_;
  FitOptions options_;  // as they suit the source
  std::shared_ptr<const PixelSolver> solver_;
  std::mutex mutex_;
  std::shared_ptr<const Tools> tools_;  // null: not yet
};

// Every step-th pixel of every step-th row of a rectangle, and what was found for it.
struct FittedSamples {
  const FitEvidence::Tools& tools;
  PixelSample sample;
  std::vector<bool> present;  // whether it has an estimate

  // As they were measured, with the exposure. values: of the same samples. Precondition: they have
  // the rows that the solver writes.
  static Result<FittedSamples> load(const FitEvidence::Tools& tools,
                                    const Measurements& measurements, const Rect& rect, int step,
                                    const ParameterBuffer& values);

  // Root mean square over the channels of the residual over its noise.
  std::vector<double> misfits() const;
  // Posterior standard deviations of a parameter. Precondition: the solver knows them.
  std::vector<float> deviations(Parameter parameter) const;
  // Precondition: the fit estimates it.
  std::vector<float> shading() const;
  // Those that are wanted, without those that cannot be told; none where there is no estimate.
  // parameter: that is shown; none: only what holds for the pixel as a whole.
  std::vector<PixelMarks> marks(PixelMarks wanted, std::optional<Parameter> parameter) const;
};

}  // namespace cutis
