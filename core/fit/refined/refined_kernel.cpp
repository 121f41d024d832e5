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
HWY_NOINLINE void Refine(const RefinedProblem<T>& problem, const RefinedPixels<T>& pixels) {
  const hn::ScalableTag<T> d;
  using R = Refiner<decltype(d)>;
  constexpr std::size_t lanes = R::kLanes;
  // A vector is left when at most half of its lanes still work; two such halves make a vector.
  constexpr std::size_t patience = lanes / 2;
  Straggler<T> aside[2 * lanes];
  std::size_t waiting = 0;
  R refiner(problem, pixels);
  const auto drain = [&](std::size_t atLeast) HWY_ATTR {
    while (waiting >= atLeast && waiting > 0) {
      const std::size_t resumed = waiting < lanes ? waiting : lanes;
      waiting -= resumed;
      refiner.Resume(aside + waiting, resumed);
      waiting += refiner.Run(waiting > 0 || atLeast > 1 ? patience : 0, aside + waiting);
    }
  };
  const std::size_t count = pixels.channels.count;
  for (std::size_t first = 0; first < count; first += lanes) {
    const std::size_t live = count - first < lanes ? count - first : lanes;
    refiner.Begin(first, live);
    waiting += refiner.Run(patience, aside + waiting);
    drain(lanes);
  }
  drain(1);
}

void RefineFloat(const RefinedProblem<float>& problem, const RefinedPixels<float>& pixels) {
  Refine(problem, pixels);
}
void RefineDouble(const RefinedProblem<double>& problem, const RefinedPixels<double>& pixels) {
  Refine(problem, pixels);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(RefineFloat);
HWY_EXPORT(RefineDouble);

template <>
void runRefinedKernel(const RefinedProblem<float>& problem, const RefinedPixels<float>& pixels) {
  HWY_DYNAMIC_DISPATCH(RefineFloat)(problem, pixels);
}

template <>
void runRefinedKernel(const RefinedProblem<double>& problem, const RefinedPixels<double>& pixels) {
  HWY_DYNAMIC_DISPATCH(RefineDouble)(problem, pixels);
}

}  // namespace cutis
#endif  // HWY_ONCE
