#include "src/app/document/fit_evidence.h"

#include <cstddef>
#include <utility>

#include "core/analyse/doubtful_value.h"
#include "core/analyse/misfit.h"
#include "core/analyse/skin_likeness.h"
#include "core/base/plane_samples.h"
#include "core/fit/discrepancy_choice.h"

namespace cutis {

FitEvidence::FitEvidence(std::shared_ptr<const SkinModel> model,
                         std::shared_ptr<const Source> source, const FitOptions& options,
                         std::shared_ptr<const PixelSolver> solver)
    : model_(std::move(model)),
      source_(std::move(source)),
      options_(suitedTo(source_->measurements, options)),
      solver_(std::move(solver)) {}

Result<std::shared_ptr<const FitEvidence::Tools>> FitEvidence::tools(Engine& engine,
                                                                     const JobContext& context) {
  const std::scoped_lock lock(mutex_);
  if (tools_ != nullptr) return tools_;
  const Rig& rig = source_->measurements.rig;
  if (solver_ == nullptr) {
    CUTIS_TRY(solver, engine.solver(model_, rig, options_, context.child(0.0, 0.7)));
    solver_ = solver;
  }
  const Profile& profile = model_->profile();
  tools_ = std::make_shared<const Tools>(
      Tools{solver_, rig, options_.noise, assumedPrior(profile, rig, options_), profile.axes});
  return tools_;
}

Result<FittedSamples> FittedSamples::load(const FitEvidence::Tools& tools,
                                          const Measurements& measurements, const Rect& rect,
                                          int step, const ParameterBuffer& values) {
  FittedSamples samples = {tools, {values.count(), {}, values.values}, values.present};
  PixelBuffer<float>& channels = samples.sample.channels;
  channels = PixelBuffer<float>(measurements.channels.size(), sampleCount(rect, step));
  const auto exposure = static_cast<float>(measurements.exposure);
  for (std::size_t k = 0; k < channels.rowCount(); ++k) {
    CUTIS_CHECK(loadSampled(measurements.channels[k], rect, step, channels[k]));
    for (float& value : channels[k])
      value *= exposure;
  }
  return samples;
}

std::vector<double> FittedSamples::misfits() const {
  PixelBuffer<float> residuals(sample.channels.rowCount(), sample.count);
  tools.solver->residuals(sample.channels.rows(), sample.values.rows(), residuals.rows());
  return misfitsOf(misfitNoise(tools.rig, tools.noise), sample.channels.rows(), residuals.rows());
}

std::vector<float> FittedSamples::deviations(Parameter parameter) const {
  PixelBuffer<float> all(sample.values.rowCount(), sample.count);
  tools.solver->deviations(sample.channels.rows(), sample.values.rows(), all.rows());
  const auto row = all[static_cast<std::size_t>(parameter)];
  return {row.begin(), row.end()};
}

std::vector<float> FittedSamples::shading() const {
  std::vector<float> factors(sample.count);
  tools.solver->shading(sample.channels.rows(), sample.values.rows(), factors.data());
  return factors;
}

std::vector<PixelMarks> FittedSamples::marks(PixelMarks wanted,
                                             std::optional<Parameter> parameter) const {
  std::vector<PixelMarks> marks(sample.count);
  const auto mark = [&](PixelMark which, const auto& holds) {
    if ((wanted & which) == 0) return;
    for (std::size_t i = 0; i < marks.size(); ++i) {
      if (present[i] && holds(i)) marks[i] = static_cast<PixelMarks>(marks[i] | which);
    }
  };
  if (wanted & kNotSkin) {
    const JudgedPixels judged = judgePixels(sample, tools.rig, *tools.solver, tools.noise);
    mark(kNotSkin, [&](std::size_t i) { return judged.isSkin[i] == 0; });
  }
  if (!parameter) return marks;
  const auto index = static_cast<std::size_t>(*parameter);
  const auto row = sample.values[index];
  mark(kAtBound, [&](std::size_t i) { return isAtBound(double{row[i]}, tools.axes[index]); });
  if ((wanted & kMostlyPrior) && tools.solver->hasDeviations()) {
    const std::vector<float> deviation = deviations(*parameter);
    mark(kMostlyPrior, [&](std::size_t i) {
      return isMostlyPrior(double{row[i]}, double{deviation[i]}, tools.prior, *parameter);
    });
  }
  return marks;
}

}  // namespace cutis
