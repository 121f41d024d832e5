#include "core/fit/refined/refined_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/fit/assumed_noise.h"
#include "core/fit/discrepancy_choice.h"
#include "core/fit/refined/coefficient_kernel.h"
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

CoefficientProblem coefficientProblem(const ChannelDiscrepancy& discrepancy) {
  CoefficientProblem line;
  line.count = static_cast<std::size_t>(discrepancy.count());
  for (int c = 0; c < discrepancy.count(); ++c) {
    line.offset[c] = static_cast<float>(discrepancy.coefficientOffset[c]);
    for (int i = 0; i < kParameterCount; ++i)
      line.slope[c][i] = static_cast<float>(discrepancy.coefficientSlope(c, i));
    for (Eigen::Index k = 0; k < discrepancy.gain.cols(); ++k)
      line.gain[c][k] = static_cast<float>(discrepancy.gain(c, k));
  }
  return line;
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
        coefficients_(coefficientProblem(discrepancy_)),
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
    fast_.solve({channels, values, converged.data(), report.iterations});
    if (exact_) exact_->finish(channels, values, report.iterations, converged.data());
    for (std::size_t i = 0; i < channels.count; ++i) {
      report.states[i] = converged[i] != 0 ? PixelState::solved : PixelState::noConvergence;
    }
    if (coefficients_.count > 0) {
      const PixelRows<float> found = {values.row(kParameterCount), coefficients_.count,
                                      values.count, values.stride};
      runCoefficientKernel(fast_.problem(), coefficients_, channels, values, found);
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
      if (!fast_.problem().isLog[k]) continue;
      for (std::size_t i = 0; i < values.count; ++i)
        deviations.at(k, i) *= values.at(k, i);
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
  CoefficientProblem coefficients_;
  FastPass fast_;
  std::unique_ptr<const ExactPass> exact_;
};

}  // namespace

std::unique_ptr<const PixelSolver> makeRefinedSolver(std::shared_ptr<const SkinModel> model,
                                                     const Rig& rig, const FitOptions& options) {
  return std::make_unique<RefinedSolver>(std::move(model), rig, options);
}

}  // namespace cutis
