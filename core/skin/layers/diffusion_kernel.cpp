#include "core/skin/layers/diffusion_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/skin/layers/diffusion_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/maths/partial-inl.h"
#include "core/skin/layers/diffusion-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <bool kDerivatives>
HWY_NOINLINE void DiffusionLoop(const DiffusionArguments& arguments) {
  const hn::ScalableTag<double> d;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t i = 0; i < arguments.count; i += lanes) {
    const std::size_t live = arguments.count - i < lanes ? arguments.count - i : lanes;
    const auto layered = LayeredReflectanceAt<kDerivatives, kDerivatives>(
        d, arguments.layers, arguments.node, LoadFirst(d, arguments.thicknessMm + i, live),
        LoadFirst(d, arguments.epidermalAbsorption + i, live),
        LoadFirst(d, arguments.dermalAbsorption + i, live));
    StoreFirst(d, layered.reflectance, arguments.reflectance + i, live);
    if constexpr (kDerivatives) {
      StoreFirst(d, layered.perEpidermalAbsorption, arguments.perEpidermal + i, live);
      StoreFirst(d, layered.perDermalAbsorption, arguments.perDermal + i, live);
      StoreFirst(d, layered.perThickness, arguments.perThickness + i, live);
    }
  }
}

void Diffuse(const DiffusionArguments& arguments) {
  arguments.perEpidermal == nullptr ? DiffusionLoop<false>(arguments)
                                    : DiffusionLoop<true>(arguments);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(Diffuse);

void runDiffusionKernel(const DiffusionArguments& arguments) {
  HWY_DYNAMIC_DISPATCH(Diffuse)(arguments);
}

}  // namespace cutis
#endif  // HWY_ONCE
