#pragma once

// The methods that the benchmark compares, and how fast each is.

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/fit/pixel_solver.h"
#include "core/fit/table/table_search.h"
#include "core/neural/chromophore_network.h"
#include "src/cli/command.h"

namespace cutis {

enum class BenchMethod {
  refinedWide,        // the profile's own prior
  refinedPopulation,  // a linear prior: the population's mean and deviation
  refinedExact,       // zero noise assumed, the profile's own prior
  network,            // what ChromNN answers
  threeStage,         // through their exact indices …
  fullSearch,
  threeStageExhaustive,  // … and entry by entry, as the paper describes them
  fullSearchExhaustive,
};
inline constexpr std::array<BenchMethod, 8> kBenchMethods = {
    BenchMethod::refinedWide,          BenchMethod::refinedPopulation,
    BenchMethod::refinedExact,         BenchMethod::network,
    BenchMethod::threeStage,           BenchMethod::fullSearch,
    BenchMethod::threeStageExhaustive, BenchMethod::fullSearchExhaustive,
};

// For people: "refined, wide prior".
const char* methodLabel(BenchMethod method);
// For scripts: "refined_wide".
const char* methodKey(BenchMethod method);
bool isRefined(BenchMethod method);
// So slow that it is run on a part of the pixels.
bool isExhaustive(BenchMethod method);

// Makes solvers for one rig; what searches share is made once. Not thread-safe.
class BenchSolvers {
 public:
  BenchSolvers(Session& session, std::shared_ptr<const SkinModel> model, const Rig& rig)
      : session_(session), model_(std::move(model)), rig_(rig) {}

  // Without one there is no solver for the method network.
  void setNetwork(std::shared_ptr<const ChromophoreNetwork> network) {
    network_ = std::move(network);
  }
  bool has(BenchMethod method) const { return method != BenchMethod::network || network_; }

  // noise: what a refined fit is told, proportional; 0 for the rig's own. Precondition:
  // has(method).
  Result<std::shared_ptr<const PixelSolver>> solver(BenchMethod method, double noise,
                                                    bool caroteneFixed = false);

 private:
  Result<std::shared_ptr<const PixelSolver>> search(BenchMethod method);

  Session& session_;
  std::shared_ptr<const SkinModel> model_;
  Rig rig_;
  std::shared_ptr<const ChromophoreNetwork> network_;
  std::array<std::shared_ptr<const PixelSolver>, kBenchMethods.size()> searches_;
};

// What solving a number of pixels gave.
struct SolvedPixels {
  std::vector<float> parameters;  // [parameter][pixel]
  std::vector<float> deviations;  // the same, if asked for
  double nanosecondsPerPixel = 0.0;
  double meanIterations = 0.0;
  double unconvergedShare = 0.0;
};

struct SolveTiming {
  bool deviations = false;  // not part of the time
  // Runs are repeated until this much has passed, at least once; the fastest counts.
  double seconds = 0.0;
};

// channels: [channel][pixel]. Batches on all cores, as a picture is solved. Cancelled if asked to
// stop.
Result<SolvedPixels> solveAll(const PixelSolver& solver, std::span<const float> channels,
                              std::size_t count, const SolveTiming& timing,
                              const JobContext& context);

}  // namespace cutis
