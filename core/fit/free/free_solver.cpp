#include "core/fit/free/free_solver.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/fit/assumed_noise.h"
#include "core/fit/free/free_search.h"
#include "core/fit/refined/refined_solver.h"
#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

// What is left when another step would lower the cost by less: a few hundredths of a posterior
// deviation.
constexpr double kFastTolerance = 1e-3;
constexpr double kExactTolerance = 1e-8;
constexpr int kFastMaximumRounds = 100;
constexpr int kExactMaximumRounds = 400;
constexpr int kMaximumNodes = 64;
// Without noise the channels are met to some 1e-5, the error of the tables; ten times that is no
// good end, a hundred times the noise that stands for none.
constexpr double kExactMisfit = 1e4;
// Pixels searched for side by side: their nodes stay in the cache.
constexpr std::size_t kBatch = 64;

// What the ordinary fit is asked for to begin with. Without noise it would bend the parameters to
// what the constants explain.
FitOptions startOptions(const Rig& rig, const FitOptions& options) {
  FitOptions start = options;
  start.free = {};
  if (asksForExact(rig, options)) start.noise = NoiseModel();
  return start;
}

template <int N>
class FreeSolver final : public PixelSolver {
 public:
  using Estimator = FreeEstimator<N>;
  using Point = typename Estimator::Point;

  FreeSolver(const std::shared_ptr<const SkinModel>& model, const Rig& rig,
             const FitOptions& options, const std::shared_ptr<const FreeResponse>& channels)
      : PixelSolver(std::make_shared<const ResponseModel>(channels)),
        start_(makeRefinedSolver(model, rig, startOptions(rig, options))),
        estimator_({channels,
                    coordinatePrior(options.prior.value_or(model->profile().prior),
                                    model->profile().axes, options.fixed),
                    usualConstantsPrior(model->profile()), assumedNoise(rig, options)}),
        exact_(asksForExact(rig, options)) {}

  void solve(const PixelBatch& batch, const SolveReport& report) const override {
    std::vector<float> found(kParameterCount * batch.count);
    start_->solve({batch.count, batch.count, packed(batch).data(), found.data()},
                  {report.states, report.iterations});
    for (std::size_t begin = 0; begin < batch.count; begin += kBatch) {
      const std::size_t end = std::min(begin + kBatch, batch.count);
      std::vector<FreeSearch<N>> searches;
      for (std::size_t i = begin; i < end; ++i)
        searches.emplace_back(i, 0.5 * (estimator_.mean() + ordinaryAt(found, batch.count, i)));
      run(batch, searches);
      searchAgain(batch, found, searches);
      for (const FreeSearch<N>& search : searches)
        write(search, batch, report);
    }
  }

  bool hasDeviations() const override { return true; }

  void deviations(const PixelBatch& batch, float* deviations) const override {
    for (std::size_t begin = 0; begin < batch.count; begin += kBatch) {
      std::vector<std::size_t> pixels(std::min(kBatch, batch.count - begin));
      std::iota(pixels.begin(), pixels.end(), begin);
      std::vector<Point> points;
      for (const std::size_t i : pixels)
        points.push_back(pointAt(batch, i));
      const auto linearised = estimator_.linearise(points, pixels, batch);
      for (std::size_t p = 0; p < pixels.size(); ++p) {
        double values[N];
        estimator_.deviationsAt(points[p], linearised[p].equations, values);
        for (std::size_t k = 0; k < N; ++k)
          deviations[k * batch.stride + pixels[p]] = static_cast<float>(values[k]);
      }
    }
  }

  const char* stage() const override { return "refined fit with free constants"; }

 private:
  // Channels side by side, as wide as the results.
  std::vector<float> packed(const PixelBatch& batch) const {
    std::vector<float> channels;
    for (std::size_t k = 0; k < static_cast<std::size_t>(channelCount()); ++k) {
      const float* row = batch.channels + k * batch.stride;
      channels.insert(channels.end(), row, row + batch.count);
    }
    return channels;
  }

  // What the ordinary fit found, [parameter][count], with the prior's constants.
  Point ordinaryAt(const std::vector<float>& found, std::size_t count, std::size_t pixel) const {
    double values[N];
    estimator_.valuesOf(estimator_.mean(), values);
    for (std::size_t k = 0; k < kParameterCount; ++k)
      values[k] = double{found[k * count + pixel]};
    return estimator_.pointOf(values);
  }

  Point pointAt(const PixelBatch& batch, std::size_t pixel) const {
    double values[N];
    for (std::size_t k = 0; k < N; ++k)
      values[k] = double{batch.parameters[k * batch.stride + pixel]};
    return estimator_.pointOf(values);
  }

  void run(const PixelBatch& batch, std::vector<FreeSearch<N>>& searches) const {
    runSearches(estimator_, batch, exact_ ? kExactTolerance : kFastTolerance,
                exact_ ? kExactMaximumRounds : kFastMaximumRounds, searches);
  }

  // Searches from elsewhere where the end is no good one, and keeps the better end.
  void searchAgain(const PixelBatch& batch, const std::vector<float>& found,
                   std::vector<FreeSearch<N>>& searches) const {
    const double most = estimator_.mostChannelCost() * (exact_ ? kExactMisfit : 1.0);
    for (const bool atMean : {false, true}) {
      std::vector<FreeSearch<N>> again;
      for (const FreeSearch<N>& search : searches) {
        if (search.channelCost() <= most) continue;
        again.emplace_back(search.pixel(), atMean ? estimator_.mean()
                                                  : ordinaryAt(found, batch.count, search.pixel()));
      }
      run(batch, again);
      auto next = again.begin();
      for (FreeSearch<N>& search : searches) {
        if (next == again.end() || next->pixel() != search.pixel()) continue;
        if (next->cost() < search.cost()) search = *next;
        ++next;
      }
    }
  }

  void write(const FreeSearch<N>& search, const PixelBatch& batch,
             const SolveReport& report) const {
    double values[N];
    estimator_.valuesOf(search.point(), values);
    const std::size_t i = search.pixel();
    for (std::size_t k = 0; k < N; ++k)
      batch.parameters[k * batch.stride + i] = static_cast<float>(values[k]);
    report.states[i] = static_cast<std::uint8_t>(search.converged() ? PixelState::solved
                                                                    : PixelState::noConvergence);
    report.iterations[i] = static_cast<std::uint16_t>(search.rounds());
  }

  std::unique_ptr<const PixelSolver> start_;
  Estimator estimator_;
  bool exact_;
};

}  // namespace

Status checkChannelsDecide(const Rig& rig, const FitOptions& options, const std::string& place) {
  const int there = independentChannelCount(rig), wanted = unknownCount(options);
  if (there >= wanted) return {};
  return usageError(place, "the lights of rig '" + rig.name + "' give " + std::to_string(there) +
                               " independent channels where " + std::to_string(wanted) +
                               " values are to be found; photograph under more lights, or leave "
                               "this out");
}

Result<std::unique_ptr<const PixelSolver>> makeFreeSolver(std::shared_ptr<const SkinModel> model,
                                                          const Rig& rig, const FitOptions& options,
                                                          const JobContext& context) {
  assert(options.free.count() > 0 && !options.shading);
  CUTIS_TRY(response, FreeResponse::make(*model, responseRows(rig), options.free,
                                         {nodeTolerance(rig, options), kMaximumNodes}, context));
  const auto channels = std::make_shared<const FreeResponse>(std::move(response));
  if (options.free.count() == 1) {
    return std::unique_ptr<const PixelSolver>(
        std::make_unique<FreeSolver<kParameterCount + 1>>(model, rig, options, channels));
  }
  return std::unique_ptr<const PixelSolver>(
      std::make_unique<FreeSolver<kParameterCount + 2>>(model, rig, options, channels));
}

}  // namespace cutis
