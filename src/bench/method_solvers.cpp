#include "src/bench/method_solvers.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/parallel.h"
#include "core/evaluate/error_protocol.h"
#include "core/fit/table/table_search.h"
#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

// Pixels handed to a solver at once, as runFit() does.
constexpr std::size_t kMethodBatch = 256;
// People whose most frequent β-carotene the first stage fixes, as in a fit.
constexpr int kTrainingPopulation = 1000;

// Every entry looked at, for each pixel.
class ExhaustiveSolver final : public PixelSolver {
 public:
  // caroteneSample: none for full search.
  ExhaustiveSolver(std::shared_ptr<const TableSearch> search, std::optional<int> caroteneSample,
                   std::shared_ptr<const ResponseModel> channels)
      : PixelSolver(std::move(channels)),
        search_(std::move(search)),
        caroteneSample_(caroteneSample) {}

  void solve(PixelRows<const float> channels, PixelRows<float> values,
             const SolveReport& report) const override {
    std::vector<double> pixel(channels.rowCount);
    std::vector<SearchFeatures> queries;
    for (std::size_t i = 0; i < channels.count; ++i) {
      for (std::size_t k = 0; k < pixel.size(); ++k)
        pixel[k] = double{channels.at(k, i)};
      queries.push_back(search_->features(pixel));
    }
    std::vector<std::size_t> entries(channels.count);
    if (caroteneSample_) {
      for (std::size_t i = 0; i < channels.count; ++i)
        entries[i] = search_->threeStage(queries[i], *caroteneSample_);
    } else {
      search_->fullSearch(queries, entries);
    }
    for (std::size_t i = 0; i < channels.count; ++i) {
      const ParameterVector found = search_->table().parameters(entries[i]);
      for (std::size_t k = 0; k < kParameterCount; ++k)
        values.at(k, i) = static_cast<float>(found[static_cast<Eigen::Index>(k)]);
      report.states[i] = PixelState::solved;
      report.iterations[i] = 0;
    }
  }

  bool hasDeviations() const override { return false; }
  void deviations(PixelRows<const float>, PixelRows<const float>, PixelRows<float>) const override {
  }
  const char* stage() const override { return "exhaustive search"; }

 private:
  std::shared_ptr<const TableSearch> search_;
  std::optional<int> caroteneSample_;
};

}  // namespace

Result<std::shared_ptr<const PixelSolver>> MethodSolvers::solver(BenchMethod method, double noise,
                                                                 bool caroteneFixed) {
  if (!isRefined(method) && method != BenchMethod::network) return search(method);
  FitOptions options;
  // The people of the protocol are the model's own.
  options.discrepancy = false;
  if (method == BenchMethod::network) {
    options.method = FitMethod::network;
    options.network = network_;
  }
  if (method == BenchMethod::refinedExact) {
    options.noise = NoiseModel{0.0, 0.0};
  } else if (noise > 0.0) {
    options.noise = NoiseModel{0.0, noise};
  }
  if (method == BenchMethod::refinedPopulation) options.prior = priorOf(protocolPopulation());
  if (caroteneFixed) options.fixed[kCarotene] = 0.0;
  return engine_.solver(model_, rig_, options, context_);
}

Result<std::shared_ptr<const PixelSolver>> MethodSolvers::search(BenchMethod method) {
  auto& kept = searches_[static_cast<std::size_t>(method)];
  if (kept) return kept;
  if (!isExhaustive(method)) {
    FitOptions options;
    options.method =
        method == BenchMethod::threeStage ? FitMethod::threeStage : FitMethod::fullSearch;
    CUTIS_TRY(made, engine_.solver(model_, rig_, options, context_));
    return kept = made;
  }
  CUTIS_TRY(table, engine_.tableSearch(*model_, rig_, context_));
  std::optional<int> carotene;
  if (method == BenchMethod::threeStageExhaustive)
    carotene = table->mostFrequentCarotene(*model_, rig_, kTrainingPopulation);
  kept = std::make_shared<const ExhaustiveSolver>(
      table, carotene, std::make_shared<const ResponseModel>(*model_, responseRows(rig_)));
  return kept;
}

Result<SolvedPixels> solveAll(const PixelSolver& solver, std::span<const float> channels,
                              std::size_t count, const SolveTiming& timing,
                              const JobContext& context) {
  using Clock = std::chrono::steady_clock;
  SolvedPixels solved;
  solved.parameters.resize(kParameterCount * count);
  if (timing.deviations) solved.deviations.resize(kParameterCount * count);
  const auto measured =
      packedRows(channels.data(), static_cast<std::size_t>(solver.channelCount()), count);
  const auto found = packedRows(solved.parameters.data(), kParameterCount, count);
  std::vector<PixelState> states(count);
  std::vector<std::uint16_t> iterations(count);
  const auto inBatches = [&](const auto& work) {
    return parallelFor((count + kMethodBatch - 1) / kMethodBatch, {context.stop, {}, {}},
                       [&](std::size_t piece) -> Status {
                         const std::size_t first = piece * kMethodBatch;
                         work(first, std::min(kMethodBatch, count - first));
                         return {};
                       });
  };
  double fastest = std::numeric_limits<double>::infinity();
  for (double passed = 0.0; passed == 0.0 || passed < timing.seconds;) {
    const auto start = Clock::now();
    CUTIS_CHECK(inBatches([&](std::size_t first, std::size_t size) {
      solver.solve(measured.part(first, size), found.part(first, size),
                   {states.data() + first, iterations.data() + first});
    }));
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    fastest = std::min(fastest, seconds);
    passed += std::max(seconds, 1e-9);
  }
  if (timing.deviations) {
    const auto deviations = packedRows(solved.deviations.data(), kParameterCount, count);
    CUTIS_CHECK(inBatches([&](std::size_t first, std::size_t size) {
      solver.deviations(measured.part(first, size), found.part(first, size),
                        deviations.part(first, size));
    }));
  }
  const auto pixels = static_cast<double>(count);
  solved.nanosecondsPerPixel = 1e9 * fastest / pixels;
  for (const std::uint16_t n : iterations)
    solved.meanIterations += n / pixels;
  solved.unconvergedShare =
      static_cast<double>(std::count(states.begin(), states.end(), PixelState::noConvergence)) /
      pixels;
  return solved;
}

}  // namespace cutis
