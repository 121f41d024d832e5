#include "core/fit/refined_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/fit/assumed_noise.h"
#include "core/fit/coordinate_prior.h"
#include "core/fit/posterior_kernel.h"
#include "core/fit/refined_kernel.h"
#include "core/fit/start_polynomial.h"
#include "core/skin/model_nodes.h"
#include "core/skin/node_model.h"
#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

// A pixel is done when the next step would lower its cost by less than this: the step it then takes
// leaves a few hundredths of a posterior deviation.
constexpr double kTolerance = 0.03;
constexpr double kExactTolerance = 1e-9;
constexpr int kMaximumRounds = 100;
constexpr int kExactMaximumRounds = 400;

// A problem with the arrays it points to, for one precision.
template <typename T>
class ProblemData {
 public:
  ProblemData(const SkinModel& model, const SpectralNodes& nodes, const Prior& prior,
              const NoiseModel& noise, const FitOptions& options)
      : model_(model, nodes.samples) {
    for (Eigen::Index k = 0; k < nodes.weights.rows(); ++k) {
      for (Eigen::Index n = 0; n < nodes.weights.cols(); ++n) {
        weights_.push_back(static_cast<T>(nodes.weights(k, n)));
      }
    }
    problem_.nodes = model_.template nodes<T>().data();
    problem_.nodeCount = model_.template nodes<T>().size();
    problem_.layers = model_.template layers<T>();
    problem_.weights = weights_.data();
    problem_.channelCount = static_cast<std::size_t>(nodes.weights.rows());
    problem_.readVariance = static_cast<T>(noise.read * noise.read);
    problem_.proportionalVariance = static_cast<T>(noise.proportional * noise.proportional);
    problem_.maximumRounds = kMaximumRounds;
    if (options.shading) {
      problem_.shadingPrecision = static_cast<T>(1.0 / (*options.shading * *options.shading));
    }
    setCoordinates(model.profile().axes, prior, options);
    setCurvature(model);
  }
  ProblemData(const ProblemData&) = delete;
  ProblemData& operator=(const ProblemData&) = delete;

  RefinedProblem<T>& problem() { return problem_; }
  const RefinedProblem<T>& problem() const { return problem_; }

 private:
  void setCoordinates(const ParameterAxes& axes, const Prior& prior, const FitOptions& options) {
    const CoordinatePrior coordinates = coordinatePrior(prior, axes, options.fixed);
    for (int i = 0; i < kParameterCount; ++i) {
      const auto index = static_cast<std::size_t>(i);
      problem_.isLog[i] = coordinates.isLog[index];
      problem_.isFixed[i] = coordinates.isFixed[index];
      problem_.low[i] = static_cast<T>(coordinates.low[i]);
      problem_.high[i] = static_cast<T>(coordinates.high[i]);
      problem_.priorMean[i] = static_cast<T>(coordinates.mean[i]);
      problem_.priorDeviation[i] = static_cast<T>(coordinates.deviation[i]);
      for (int j = 0; j < kParameterCount; ++j) {
        problem_.priorPrecision[i][j] = static_cast<T>(coordinates.precision(i, j));
      }
    }
  }

  // Where a chromophore outweighs the absorption of the tissue without it, in the green.
  void setCurvature(const SkinModel& model) {
    constexpr int green = (550 - kFirstWavelengthNm) / kWavelengthStepNm;
    const auto offset = [&](int i, double base, double chromophore) {
      problem_.rootOffset[i] = static_cast<T>(base / chromophore);
    };
    offset(kMelanin, model.epidermis().base[green], model.epidermis().eumelanin[green]);
    offset(kHaemoglobinDermal, model.dermis().base[green], model.dermis().blood[green]);
  }

  NodeModel model_;
  std::vector<T> weights_;
  RefinedProblem<T> problem_ = {};
};

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
    single_.problem().tolerance = static_cast<float>(kTolerance);
    const auto solveFrom = [this](const StartPolynomial& start, std::size_t count,
                                  const float* channels, float* coordinates) {
      std::vector<std::uint8_t> converged(count);
      std::vector<std::uint16_t> rounds(count);
      single_.problem().start = &start;
      runRefinedKernel<float>(single_.problem(), {count, count, channels, coordinates,
                                                  converged.data(), rounds.data()});
    };
    start_ = trainStartPolynomial({*model_, channelModel().nodes(), prior_, noise_, options.fixed,
                                   options.shading.value_or(0.0)},
                                  solveFrom);
    single_.problem().start = &start_;
    if (asksForExact(rig, options) && seeingChannelCount(rig) >= unknownCount(options)) {
      double_ = std::make_unique<ProblemData<double>>(*model_, channelModel().nodes(), prior_,
                                                      noise_, options);
      double_->problem().tolerance = kExactTolerance;
      double_->problem().maximumRounds = kExactMaximumRounds;
    }
  }

  void solve(const PixelBatch& batch, const SolveReport& report) const override {
    std::vector<std::uint8_t> converged(batch.count);
    std::fill_n(report.iterations, batch.count, std::uint16_t{0});
    const RefinedBatch<float> refined = {batch.count,      batch.stride,     batch.channels,
                                         batch.parameters, converged.data(), report.iterations};
    runRefinedKernel(single_.problem(), refined);
    if (double_) finishExactly(batch, report, converged);
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
  void finishExactly(const PixelBatch& batch, const SolveReport& report,
                     std::vector<std::uint8_t>& converged) const {
    std::vector<double> coordinates(kParameterCount * batch.stride);
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      std::copy_n(batch.parameters + k * batch.stride, batch.count,
                  coordinates.data() + k * batch.stride);
    }
    const RefinedBatch<double> refined = {batch.count,        batch.stride,     batch.channels,
                                          coordinates.data(), converged.data(), report.iterations};
    runRefinedKernel(double_->problem(), refined);
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      for (std::size_t i = 0; i < batch.count; ++i) {
        batch.parameters[k * batch.stride + i] =
            static_cast<float>(coordinates[k * batch.stride + i]);
      }
    }
  }

  // From coordinates, in place.
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
  StartPolynomial start_ = {};
  ProblemData<float> single_;
  std::unique_ptr<ProblemData<double>> double_;
};

}  // namespace

std::unique_ptr<const PixelSolver> makeRefinedSolver(std::shared_ptr<const SkinModel> model,
                                                     const Rig& rig, const FitOptions& options) {
  return std::make_unique<RefinedSolver>(std::move(model), rig, options);
}

}  // namespace cutis
