#pragma once  // internal to src/bench

// The methods that the benchmark compares, and their names.

#include <array>

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

}  // namespace cutis
