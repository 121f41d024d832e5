#include "core/fit/refined/refined_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fit/refined/refined_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/fit/refined/refiner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <typename T>
HWY_NOINLINE void Refine(const RefinedProblem<T>& problem, const RefinedBatch<T>& batch) {
  const hn::ScalableTag<T> d;
  using R = Refiner<decltype(d)>;
  constexpr std::size_t lanes = R::kLanes;
  // A vector is left when at most half of its lanes still work; two such halves make a vector.
  constexpr std::size_t patience = lanes / 2;
  Straggler<T> aside[2 * lanes];
  std::size_t waiting = 0;
  R refiner(problem, batch);
  const auto drain = [&](std::size_t atLeast) HWY_ATTR {
    while (waiting >= atLeast && waiting > 0) {
      const std::size_t count = waiting < lanes ? waiting : lanes;
      waiting -= count;
      refiner.Resume(aside + waiting, count);
      waiting += refiner.Run(waiting > 0 || atLeast > 1 ? patience : 0, aside + waiting);
    }
  };
  for (std::size_t first = 0; first < batch.count; first += lanes) {
    const std::size_t live = batch.count - first < lanes ? batch.count - first : lanes;
    refiner.Begin(first, live);
    waiting += refiner.Run(patience, aside + waiting);
    drain(lanes);
  }
  drain(1);
}

void RefineFloat(const RefinedProblem<float>& problem, const RefinedBatch<float>& batch) {
  Refine(problem, batch);
}
void RefineDouble(const RefinedProblem<double>& problem, const RefinedBatch<double>& batch) {
  Refine(problem, batch);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(RefineFloat);
HWY_EXPORT(RefineDouble);

template <>
void runRefinedKernel(const RefinedProblem<float>& problem, const RefinedBatch<float>& batch) {
  HWY_DYNAMIC_DISPATCH(RefineFloat)(problem, batch);
}

template <>
void runRefinedKernel(const RefinedProblem<double>& problem, const RefinedBatch<double>& batch) {
  HWY_DYNAMIC_DISPATCH(RefineDouble)(problem, batch);
}

}  // namespace cutis
#endif  // HWY_ONCE
