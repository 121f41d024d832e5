#include "core/fit/refined/refined_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/fit/assumed_noise.h"
#include "core/fit/deviation_limit.h"
#include "core/fit/discrepancy_choice.h"
#include "core/fit/refined/exact_pass.h"
#include "core/fit/refined/fast_pass.h"
#include "core/fit/refined/posterior_kernel.h"
#include "core/skin/model/choose_nodes.h"

namespace cutis {
namespace {

std::optional<ShadingModel> shadingOf(const Rig& rig, const FitOptions& options) {
  if (!options.shading) return {};
  return ShadingModel{assumedNoise(rig, options), *options.shading};
}

ChannelDiscrepancy discrepancyOf(const SkinModel& model, const Prior& prior, const Rig& rig,
                                 const FitOptions& options) {
  const Discrepancy* discrepancy = chosenDiscrepancy(model.profile(), rig, options);
  if (discrepancy == nullptr) return {};
  return channelDiscrepancy(*discrepancy, model, responseRows(rig),
                            coordinatePrior(prior, model.profile().axes, options.fixed));
}

class RefinedSolver final : public PixelSolver {
 public:
  RefinedSolver(std::shared_ptr<const SkinModel> model, const Rig& rig, const FitOptions& options)
      : PixelSolver(std::make_shared<ResponseModel>(
                        *model, responseRows(rig),
                        NodeOptions{nodeTolerance(rig, options), int{kMaximumFitNodes}},
                        chosenDiscrepancy(model->profile(), rig, options)),
                    shadingOf(rig, options)),
        model_(std::move(model)),
        prior_(assumedPrior(model_->profile(), rig, options)),
        noise_(assumedNoise(rig, options)),
        discrepancy_(discrepancyOf(*model_, prior_, rig, options)),
        fast_(*model_, channelModel().nodes(), prior_, noise_, options, discrepancy_) {
    if (asksForExact(rig, options) && seeingChannelCount(rig) >= unknownCount(options)) {
      exact_ = std::make_unique<const ExactPass>(*model_, channelModel().nodes(), prior_, noise_,
                                                 options, discrepancy_);
    }
  }

  void solve(PixelRows<const float> channels, PixelRows<float> values,
             const SolveReport& report) const override {
    std::vector<std::uint8_t> converged(channels.count);
    std::fill_n(report.iterations, channels.count, std::uint16_t{0});
    PixelRows<float> coefficients = {};
    if (!discrepancy_.empty()) {
      coefficients = {values.row(kParameterCount), static_cast<std::size_t>(discrepancy_.count()),
                      values.count, values.stride};
    }
    fast_.solve({channels, values, converged.data(), report.iterations, nullptr, coefficients});
    if (exact_) {
      exact_->finish(channels, values, coefficients, report.iterations, converged.data());
    }
    for (std::size_t i = 0; i < channels.count; ++i) {
      report.states[i] = converged[i] != 0 ? PixelState::solved : PixelState::noConvergence;
    }
    toParameters(values);
  }

  bool hasDeviations() const override { return true; }

  void deviations(PixelRows<const float> channels, PixelRows<const float> values,
                  PixelRows<float> deviations) const override {
    PixelBuffer<float> coordinates(kParameterCount, values.count);
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      const std::span<float> row = coordinates[k];
      std::copy_n(values.row(k), values.count, row.begin());
      if (!fast_.problem().isLog[k]) continue;
      for (float& value : row)
        value = std::log(value);
    }
    runPosteriorKernel(fast_.problem(), channels, coordinates.rows(), deviations);
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      const double maximum = model_->profile().axes[k].maximum;
      for (std::size_t i = 0; i < values.count; ++i) {
        float& deviation = deviations.at(k, i);
        if (fast_.problem().isLog[k]) deviation *= values.at(k, i);
        deviation = static_cast<float>(
            limitedDeviation(double{deviation}, double{values.at(k, i)}, maximum));
      }
    }
  }

  const char* stage() const override { return "refined fit"; }

 private:
  // Turns coordinates into parameters, in place.
  void toParameters(PixelRows<float> coordinates) const {
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      if (!fast_.problem().isLog[k]) continue;
      float* row = coordinates.row(k);
      for (std::size_t i = 0; i < coordinates.count; ++i)
        row[i] = std::exp(row[i]);
    }
  }

  std::shared_ptr<const SkinModel> model_;
  Prior prior_;
  NoiseModel noise_;
  ChannelDiscrepancy discrepancy_;  // empty: none
  FastPass fast_;
  std::unique_ptr<const ExactPass> exact_;
};

}  // namespace

std::unique_ptr<const PixelSolver> makeRefinedSolver(std::shared_ptr<const SkinModel> model,
                                                     const Rig& rig, const FitOptions& options) {
  return std::make_unique<RefinedSolver>(std::move(model), rig, options);
}

}  // namespace cutis
