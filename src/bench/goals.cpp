#include "src/bench/goals.h"

#include <algorithm>

namespace cutis {
namespace {

// That a time was scaled, if it was.
std::string remarkOn(int size) {
  return size == kUsualSize ? "" : ", scaled from " + std::to_string(size) + "²";
}

void addPictures(const BenchFigures& figures, std::vector<Goal>& goals) {
  if (const auto* row = largestPicture(figures, BenchMethod::refinedWide)) {
    goals.push_back({"refined_seconds",
                     "refined fit of 2048² at 0.5 %, wide prior" + remarkOn(row->size),
                     GoalUnit::seconds,
                     {},
                     0.9,
                     usualScaling(row->size) * row->seconds,
                     true});
  }
  if (const auto& first = figures.firstPicture) {
    goals.push_back({"first_picture_seconds",
                     "first maps of 2048²" + remarkOn(first->size),
                     GoalUnit::seconds,
                     {},
                     0.2,
                     usualScaling(first->size) * first->seconds,
                     true});
  }
}

void addExact(const BenchFigures& figures, std::vector<Goal>& goals) {
  const auto* errors = figuresOf(figures.methods, BenchMethod::refinedExact, 0.0);
  if (errors == nullptr) return;
  goals.push_back({"exact_visible_mse",
                   "vis MSE, exact setting, no noise",
                   GoalUnit::meanSquare,
                   {},
                   3e-8,
                   errors->errors.visibleMse,
                   false});
  if (const auto* row = largestPicture(figures, BenchMethod::refinedExact)) {
    goals.push_back({"exact_seconds",
                     "exact setting, 2048² without noise" + remarkOn(row->size),
                     GoalUnit::seconds,
                     {},
                     8.0,
                     usualScaling(row->size) * row->seconds,
                     true});
  }
}

void addOverBound(const BenchFigures& figures, BenchMethod method, const char* key,
                  const char* prior, double most, std::vector<Goal>& goals) {
  double worst = 0.0;
  for (const MethodFigures& row : figures.methods) {
    if (row.method == method && row.overBound) worst = std::max(worst, *row.overBound);
  }
  if (worst == 0.0) return;
  goals.push_back({key,
                   "vis MSE over the bound, worst of 0.1 to 1 %, " + std::string(prior),
                   GoalUnit::none,
                   {},
                   most,
                   worst,
                   false});
}

void addCoverage(const BenchFigures& figures, std::vector<Goal>& goals) {
  for (const CoverageFigures& row : figures.coverage) {
    const std::string of = ", " + row.prior + " prior";
    const Coverage::Count measured = pooled(row.coverage.measured);
    const Coverage::Count assumed = pooled(row.coverage.assumed);
    if (measured.pixels > 0) {
      goals.push_back({"coverage_measured_" + row.prior, "within 2 sd where the data decide" + of,
                       GoalUnit::percent, 93.0, 97.0, 100.0 * measured.share(), false});
    }
    if (assumed.pixels > 0) {
      goals.push_back({"coverage_elsewhere_" + row.prior,
                       "within 2 sd elsewhere" + of,
                       GoalUnit::percent,
                       93.0,
                       {},
                       100.0 * assumed.share(),
                       false});
    }
  }
}

void addSpeed(const BenchFigures& figures, std::vector<Goal>& goals) {
  if (figures.speedRatio) {
    goals.push_back({"speed_ratio",
                     "times as fast as three stages, exhaustive",
                     GoalUnit::none,
                     300.0,
                     {},
                     *figures.speedRatio,
                     true});
  }
  const auto addSearch = [&](BenchMethod method, const char* key, double most) {
    if (const auto* row = figuresOf(figures.methods, method, kUsualNoise)) {
      goals.push_back({key,
                       methodLabel(method) + std::string(", a pixel"),
                       GoalUnit::microseconds,
                       {},
                       most,
                       1e-3 * row->nanosecondsPerPixel,
                       true});
    }
  };
  addSearch(BenchMethod::threeStage, "three_stage_microseconds", 5.0);
  addSearch(BenchMethod::fullSearch, "full_search_microseconds", 20.0);
}

void addNetworks(const BenchFigures& figures, std::vector<Goal>& goals) {
  if (!figures.networks.empty()) {
    const NetworkFigures& row = figures.networks.front();
    goals.push_back({"network_visible_mse",
                     "vis MSE, network, encode + decode, no noise",
                     GoalUnit::meanSquare,
                     {},
                     1e-5,
                     row.errors.front().bothMse,
                     false});
    goals.push_back({"spectra_network_visible_mse",
                     "vis MSE, SpectraNN alone",
                     GoalUnit::meanSquare,
                     {},
                     1e-6,
                     row.decoded.visible,
                     false});
    goals.push_back({"network_seconds",
                     "network, encode + decode of 2048²" + remarkOn(row.size),
                     GoalUnit::seconds,
                     {},
                     0.6,
                     usualScaling(row.size) * row.bothSeconds,
                     false});
  }
  if (figures.trainingSeconds) {
    goals.push_back({"training_seconds",
                     "networks for a new rig, training",
                     GoalUnit::seconds,
                     {},
                     300.0,
                     *figures.trainingSeconds,
                     false});
  }
}

}  // namespace

std::vector<Goal> goalsOf(const BenchFigures& figures) {
  std::vector<Goal> goals;
  addPictures(figures, goals);
  addOverBound(figures, BenchMethod::refinedPopulation, "over_bound_population",
               "population's prior", 1.05, goals);
  addOverBound(figures, BenchMethod::refinedWide, "over_bound_wide", "wide prior", 1.3, goals);
  addExact(figures, goals);
  addCoverage(figures, goals);
  addSpeed(figures, goals);
  addNetworks(figures, goals);
  return goals;
}

}  // namespace cutis
