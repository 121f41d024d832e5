#pragma once  // internal to src/bench

// Solvers of the methods that the benchmark compares, and how fast each is.

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/pixel_solver.h"
#include "core/neural/chromophore_network.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "src/app/engine.h"
#include "src/bench/method.h"

namespace cutis {

// Makes solvers for one rig; what searches share is made once. Not thread-safe.
class MethodSolvers {
 public:
  // engine: outlives this. context: whether to stop; nothing is reported to it.
  MethodSolvers(Engine& engine, std::shared_ptr<const SkinModel> model, const Rig& rig,
                const JobContext& context)
      : engine_(engine), model_(std::move(model)), rig_(rig), context_{context.stop, {}, {}} {}

  // Without one there is no solver for the method network.
  void setNetwork(std::shared_ptr<const ChromophoreNetwork> network) {
    network_ = std::move(network);
  }
  bool has(BenchMethod method) const { return method != BenchMethod::network || network_; }

  // noise: what a refined fit assumes, proportional; 0 for the rig's own. Precondition:
  // has(method).
  Result<std::shared_ptr<const PixelSolver>> solver(BenchMethod method, double noise,
                                                    bool caroteneFixed = false);

 private:
  Result<std::shared_ptr<const PixelSolver>> search(BenchMethod method);

  Engine& engine_;
  std::shared_ptr<const SkinModel> model_;
  Rig rig_;
  JobContext context_;
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
