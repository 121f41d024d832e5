#include "core/fit/free/free_solver.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/base/echoed_text.h"
#include "core/fit/assumed_noise.h"
#include "core/fit/free/free_search.h"
#include "core/fit/refined/refined_solver.h"

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
  start.discrepancy = false;
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
                    usualFreePrior(model->profile()), assumedNoise(rig, options)}),
        exact_(asksForExact(rig, options)) {}

  void solve(PixelRows<const float> channels, PixelRows<float> values,
             const SolveReport& report) const override {
    // What the ordinary fit finds.
    PixelBuffer<float> ordinary(kParameterCount, channels.count);
    start_->solve(channels, ordinary.rows(), report);
    for (std::size_t begin = 0; begin < channels.count; begin += kBatch) {
      const std::size_t end = std::min(begin + kBatch, channels.count);
      std::vector<FreeSearch<N>> searches;
      for (std::size_t i = begin; i < end; ++i)
        searches.push_back(searchFrom(i, 0.5 * (estimator_.mean() + ordinaryAt(ordinary, i))));
      run(channels, searches);
      searchAgain(channels, ordinary, searches);
      for (const FreeSearch<N>& search : searches)
        write(search, values, report);
    }
  }

  bool hasDeviations() const override { return true; }

  void deviations(PixelRows<const float> channels, PixelRows<const float> values,
                  PixelRows<float> deviations) const override {
    for (std::size_t begin = 0; begin < channels.count; begin += kBatch) {
      std::vector<std::size_t> pixels(std::min(kBatch, channels.count - begin));
      std::iota(pixels.begin(), pixels.end(), begin);
      std::vector<Point> points;
      for (const std::size_t i : pixels)
        points.push_back(pointAt(values, i));
      const auto linearised = estimator_.linearise(points, pixels, channels);
      for (std::size_t p = 0; p < pixels.size(); ++p) {
        double own[N];
        estimator_.deviationsAt(points[p], linearised[p].equations, own);
        for (std::size_t k = 0; k < N; ++k)
          deviations.at(k, pixels[p]) = static_cast<float>(own[k]);
      }
    }
  }

  const char* stage() const override { return "refined fit with free constants"; }

 private:
  FreeSearch<N> searchFrom(std::size_t pixel, const Point& start) const {
    return {pixel, start, exact_ ? kExactMaximumRounds : kFastMaximumRounds};
  }

  // What the ordinary fit found, with the prior's constants.
  Point ordinaryAt(const PixelBuffer<float>& ordinary, std::size_t pixel) const {
    double values[N];
    estimator_.valuesOf(estimator_.mean(), values);
    for (std::size_t k = 0; k < kParameterCount; ++k)
      values[k] = double{ordinary[k][pixel]};
    return estimator_.pointOf(values);
  }

  Point pointAt(PixelRows<const float> values, std::size_t pixel) const {
    double own[N];
    for (std::size_t k = 0; k < N; ++k)
      own[k] = double{values.at(k, pixel)};
    return estimator_.pointOf(own);
  }

  void run(PixelRows<const float> channels, std::vector<FreeSearch<N>>& searches) const {
    const auto evaluate = [&](const std::vector<FreeSearch<N>*>& active) {
      std::vector<Point> points;
      std::vector<std::size_t> pixels;
      for (const FreeSearch<N>* search : active) {
        points.push_back(search->trial());
        pixels.push_back(search->pixel());
      }
      return estimator_.linearise(points, pixels, channels);
    };
    const double tolerance = exact_ ? kExactTolerance : kFastTolerance;
    runSearches(
        searches, evaluate,
        [&](FreeSearch<N>& search, const auto& came) { return search.advance(came, tolerance); },
        [] { return false; });
  }

  // Searches from elsewhere where the end is no good one, and keeps the better end.
  void searchAgain(PixelRows<const float> channels, const PixelBuffer<float>& ordinary,
                   std::vector<FreeSearch<N>>& searches) const {
    const double most = estimator_.mostChannelCost() * (exact_ ? kExactMisfit : 1.0);
    for (const bool atMean : {false, true}) {
      std::vector<FreeSearch<N>> again;
      for (const FreeSearch<N>& search : searches) {
        if (search.channelCost() <= most) continue;
        again.push_back(searchFrom(
            search.pixel(), atMean ? estimator_.mean() : ordinaryAt(ordinary, search.pixel())));
      }
      run(channels, again);
      auto next = again.begin();
      for (FreeSearch<N>& search : searches) {
        if (next == again.end() || next->pixel() != search.pixel()) continue;
        if (next->cost() < search.cost()) search = *next;
        ++next;
      }
    }
  }

  void write(const FreeSearch<N>& search, PixelRows<float> values,
             const SolveReport& report) const {
    double own[N];
    estimator_.valuesOf(search.point(), own);
    const std::size_t i = search.pixel();
    for (std::size_t k = 0; k < N; ++k)
      values.at(k, i) = static_cast<float>(own[k]);
    report.states[i] = search.converged() ? PixelState::solved : PixelState::noConvergence;
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
  return usageError(place, "the lights of rig " + inQuotes(rig.name) + " give " +
                               std::to_string(there) + " independent channels where " +
                               std::to_string(wanted) +
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
