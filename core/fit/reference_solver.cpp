#include "core/fit/reference_solver.h"

#include <cstddef>

#include "core/fit/map_estimator.h"
#include "core/skin/model_nodes.h"
#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

EstimatorOptions estimatorOptions(const SkinModel& model, const Rig& rig,
                                  const FitOptions& options) {
  EstimatorOptions estimator;
  estimator.prior = options.prior.value_or(model.profile().prior);
  estimator.noise = options.noise.value_or(rig.noise);
  estimator.fixed = options.fixed;
  return estimator;
}

class ReferenceSolver final : public PixelSolver {
 public:
  ReferenceSolver(std::shared_ptr<const SkinModel> model, const Rig& rig,
                  const FitOptions& options)
      : model_(std::move(model)),
        nodes_(chooseModelNodes(*model_, responseRows(rig))),
        estimator_(*model_, nodes_, estimatorOptions(*model_, rig, options)) {}

  void solve(const SolveBatch& batch) const override {
    Eigen::VectorXd channels(nodes_.weights.rows());
    for (std::size_t i = 0; i < batch.count; ++i) {
      for (Eigen::Index k = 0; k < channels.size(); ++k) {
        channels[k] = batch.channels[static_cast<std::size_t>(k) * batch.stride + i];
      }
      write(batch, i, estimator_.solve(channels));
    }
  }
  const char* stage() const override { return "refined fit"; }
  int nodeCount() const override { return static_cast<int>(nodes_.samples.size()); }
  bool hasDeviations() const override { return true; }

 private:
  static void write(const SolveBatch& batch, std::size_t i, const Estimate& estimate) {
    for (int k = 0; k < kParameterCount; ++k) {
      const std::size_t at = static_cast<std::size_t>(k) * batch.stride + i;
      batch.parameters[at] = static_cast<float>(estimate.parameters[k]);
      if (batch.deviations != nullptr) {
        batch.deviations[at] = static_cast<float>(estimate.deviations[k]);
      }
    }
    batch.states[i] = static_cast<std::uint8_t>(estimate.converged ? PixelState::solved
                                                                   : PixelState::noConvergence);
    batch.iterations[i] = static_cast<std::uint16_t>(estimate.iterations);
    if (batch.residuals == nullptr) return;
    for (Eigen::Index k = 0; k < estimate.residual.size(); ++k) {
      batch.residuals[static_cast<std::size_t>(k) * batch.stride + i] =
          static_cast<float>(estimate.residual[k]);
    }
  }

  std::shared_ptr<const SkinModel> model_;
  SpectralNodes nodes_;
  MapEstimator estimator_;
};

}  // namespace

std::unique_ptr<const PixelSolver> makeReferenceSolver(std::shared_ptr<const SkinModel> model, const Rig& rig,
                                                       const FitOptions& options) {
  return std::make_unique<ReferenceSolver>(std::move(model), rig, options);
}

}  // namespace cutis
