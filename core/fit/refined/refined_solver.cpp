#include "core/fit/refined/refined_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/fit/assumed_noise.h"
#include "core/fit/refined/exact_pass.h"
#include "core/fit/refined/fast_pass.h"
#include "core/fit/refined/posterior_kernel.h"
#include "core/skin/model/choose_nodes.h"
#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

std::optional<ShadingModel> shadingOf(const Rig& rig, const FitOptions& options) {
  if (!options.shading) return {};
  return ShadingModel{assumedNoise(rig, options), *options.shading};
}

class RefinedSolver final : public PixelSolver {
 public:
  RefinedSolver(std::shared_ptr<const SkinModel> model, const Rig& rig, const FitOptions& options)
      : PixelSolver(std::make_shared<ResponseModel>(
                        *model, responseRows(rig),
                        NodeOptions{nodeTolerance(rig, options), int{kMaximumFitNodes}}),
                    shadingOf(rig, options)),
        model_(std::move(model)),
        prior_(options.prior.value_or(model_->profile().prior)),
        noise_(assumedNoise(rig, options)),
        single_(*model_, channelModel().nodes(), prior_, noise_, options) {
    if (asksForExact(rig, options) && seeingChannelCount(rig) >= unknownCount(options)) {
      exact_ = std::make_unique<const ExactPass>(*model_, channelModel().nodes(), prior_, noise_,
                                                 options);
    }
  }

  void solve(const PixelBatch& batch, const SolveReport& report) const override {
    std::vector<std::uint8_t> converged(batch.count);
    std::fill_n(report.iterations, batch.count, std::uint16_t{0});
    const RefinedBatch<float> refined = {batch.count,      batch.stride,     batch.channels,
                                         batch.parameters, converged.data(), report.iterations};
    single_.solve(refined);
    if (exact_) exact_->finish(batch, report.iterations, converged.data());
    for (std::size_t i = 0; i < batch.count; ++i) {
      report.states[i] = static_cast<std::uint8_t>(converged[i] != 0 ? PixelState::solved
                                                                     : PixelState::noConvergence);
    }
    toParameters(batch);
  }

  bool hasDeviations() const override { return true; }

  void deviations(const PixelBatch& batch, float* deviations) const override {
    std::vector<float> coordinates(kParameterCount * batch.stride);
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      const float* from = batch.parameters + k * batch.stride;
      float* to = coordinates.data() + k * batch.stride;
      std::copy_n(from, batch.count, to);
      if (!single_.problem().isLog[k]) continue;
      for (std::size_t i = 0; i < batch.count; ++i)
        to[i] = std::log(to[i]);
    }
    runPosteriorKernel(single_.problem(),
                       {batch.count, batch.stride, batch.channels, coordinates.data(), deviations});
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      if (!single_.problem().isLog[k]) continue;
      for (std::size_t i = 0; i < batch.count; ++i) {
        deviations[k * batch.stride + i] *= batch.parameters[k * batch.stride + i];
      }
    }
  }

  const char* stage() const override { return "refined fit"; }

 private:
  // Turns coordinates into parameters, in place.
  void toParameters(const PixelBatch& batch) const {
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      if (!single_.problem().isLog[k]) continue;
      float* row = batch.parameters + k * batch.stride;
      for (std::size_t i = 0; i < batch.count; ++i)
        row[i] = std::exp(row[i]);
    }
  }

  std::shared_ptr<const SkinModel> model_;
  Prior prior_;
  NoiseModel noise_;
  FastPass single_;
  std::unique_ptr<const ExactPass> exact_;
};

}  // namespace

std::unique_ptr<const PixelSolver> makeRefinedSolver(std::shared_ptr<const SkinModel> model,
                                                     const Rig& rig, const FitOptions& options) {
  return std::make_unique<RefinedSolver>(std::move(model), rig, options);
}

}  // namespace cutis
