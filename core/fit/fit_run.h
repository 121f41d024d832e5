#pragma once

// Solving a whole picture: which pixels, in which order, each how often.
//
// Tiles are independent and run on all cores, those in view first. Masked, black, saturated and
// non-finite pixels are never solved; equal pixels of a tile are solved once. What was done and
// what was skipped is counted.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/fit/fit_options.h"
#include "core/fit/pixel_solver.h"
#include "core/rig/measurements.h"
#include "core/skin/chromophore_maps.h"

namespace cutis {

// What a fit writes. Planes are handles: a view may show them while they fill.
struct FitPlanes {
  ChromophoreMaps maps;
  std::vector<Plane> deviations;  // one per parameter and then per free constant, or none
  std::vector<Plane> residuals;   // one per channel, or none
  Plane shading;                  // factor on all channels; empty unless it was estimated

  FitPlanes() = default;
  FitPlanes(const Measurements& measurements, const FitOptions& options,
            const std::shared_ptr<TileStore>& store);
};

struct FitStatistics {
  struct Pixels {
    std::uint64_t total = 0;
    std::uint64_t masked = 0;
    std::uint64_t invalid = 0;
    std::uint64_t saturated = 0;
    std::uint64_t duplicate = 0;      // took the result of an equal pixel
    std::uint64_t solved = 0;         // were solved themselves
    std::uint64_t noConvergence = 0;  // of those and their duplicates, met the iteration limit
  } pixels;
  double meanIterations = 0.0;  // over pixels solved
  int maximumIterations = 0;
  // Root mean square over the channels of a pixel, measured minus modelled; over every eighth pixel
  // of every eighth row.
  double meanResidual = 0.0;
  double residual95 = 0.0;  // 95 of 100 pixels are below
};

struct FitObserver {
  // A rectangle of the planes has its final values. Called from any thread.
  std::function<void(const Rect&)> finished;
  // What somebody looks at now, in pixels: tiles near its middle come first. Called from any
  // thread.
  std::function<Rect()> view;
};

// Fills planes, which were made for these measurements. Cancelled if asked to stop: the planes are
// then filled in part.
Result<FitStatistics> runFit(const Measurements& measurements, const PixelSolver& solver,
                             FitPlanes planes, const JobContext& context,
                             const FitObserver& observer = {});

}  // namespace cutis
