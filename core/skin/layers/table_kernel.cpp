#include "core/skin/layers/table_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/skin/layers/table_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/maths/partial-inl.h"
#include "core/skin/layers/table-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <bool kDerivatives, typename T>
HWY_NOINLINE void LayerTableLoop(const LayerTableArguments<T>& arguments) {
  const hn::ScalableTag<T> d;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t i = 0; i < arguments.count; i += lanes) {
    const std::size_t live = arguments.count - i < lanes ? arguments.count - i : lanes;
    const auto layered = TabulatedReflectanceOf<kDerivatives>(
        d, *arguments.polynomial, LoadFirst(d, arguments.epidermalAbsorption + i, live),
        LoadFirst(d, arguments.dermalAbsorption + i, live));
    StoreFirst(d, layered.reflectance, arguments.reflectance + i, live);
    if constexpr (kDerivatives) {
      StoreFirst(d, layered.perEpidermalAbsorption, arguments.perEpidermal + i, live);
      StoreFirst(d, layered.perDermalAbsorption, arguments.perDermal + i, live);
    }
  }
}

template <typename T>
void LayerTableDispatch(const LayerTableArguments<T>& arguments) {
  arguments.perEpidermal == nullptr ? LayerTableLoop<false>(arguments)
                                    : LayerTableLoop<true>(arguments);
}

void LayerTableFloat(const LayerTableArguments<float>& arguments) {
  LayerTableDispatch(arguments);
}
void LayerTableDouble(const LayerTableArguments<double>& arguments) {
  LayerTableDispatch(arguments);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(LayerTableFloat);
HWY_EXPORT(LayerTableDouble);

template <>
void runLayerTableKernel(const LayerTableArguments<float>& arguments) {
  HWY_DYNAMIC_DISPATCH(LayerTableFloat)(arguments);
}

template <>
void runLayerTableKernel(const LayerTableArguments<double>& arguments) {
  HWY_DYNAMIC_DISPATCH(LayerTableDouble)(arguments);
}

}  // namespace cutis
#endif  // HWY_ONCE
