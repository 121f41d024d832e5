#include "src/bench/method.h"

namespace cutis {
namespace {

struct MethodName {
  const char* label;
  const char* key;
};

MethodName nameOf(BenchMethod method) {
  switch (method) {
    case BenchMethod::refinedWide:
      return {"refined, wide prior", "refined_wide"};
    case BenchMethod::refinedPopulation:
      return {"refined, population's prior", "refined_population"};
    case BenchMethod::refinedExact:
      return {"refined, exact", "refined_exact"};
    case BenchMethod::network:
      return {"network", "network"};
    case BenchMethod::threeStage:
      return {"three stages, indexed", "three_stage"};
    case BenchMethod::fullSearch:
      return {"full search, indexed", "full_search"};
    case BenchMethod::threeStageExhaustive:
      return {"three stages, exhaustive", "three_stage_exhaustive"};
    case BenchMethod::fullSearchExhaustive:
      return {"full search, exhaustive", "full_search_exhaustive"};
  }
  return {"", ""};
}

}  // namespace

const char* methodLabel(BenchMethod method) {
  return nameOf(method).label;
}

const char* methodKey(BenchMethod method) {
  return nameOf(method).key;
}

bool isRefined(BenchMethod method) {
  return method == BenchMethod::refinedWide || method == BenchMethod::refinedPopulation ||
         method == BenchMethod::refinedExact;
}

bool isExhaustive(BenchMethod method) {
  return method == BenchMethod::threeStageExhaustive || method == BenchMethod::fullSearchExhaustive;
}

}  // namespace cutis
