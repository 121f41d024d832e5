#include "core/skin/model/reflectance_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/skin/model/reflectance_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/maths/partial-inl.h"
#include "core/skin/layers/node_reflectance-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <bool kDerivatives, typename T>
HWY_NOINLINE void Batch(const ReflectanceArguments<T>& arguments) {
  const hn::ScalableTag<T> d;
  using V = hn::Vec<decltype(d)>;
  const std::size_t lanes = hn::Lanes(d);
  const PixelRows<const T> parameters = arguments.parameters;
  for (std::size_t i = 0; i < parameters.count; i += lanes) {
    const std::size_t live = parameters.count - i < lanes ? parameters.count - i : lanes;
    const auto load = [&](std::size_t k) HWY_ATTR {
      return LoadFirst(d, parameters.data + k * parameters.stride + i, live);
    };
    const AmountVectors<V> skin = AmountsOf(load);
    for (std::size_t n = 0; n < arguments.nodeCount; ++n) {
      V epidermal, dermal;
      NodeAbsorption(d, arguments.nodes[n], skin, epidermal, dermal);
      const LayeredVectors<V> layered = NodeReflectanceOf<kDerivatives>(
          d, arguments.layers, arguments.nodes[n], epidermal, dermal);
      const auto store = [&](V value, const PixelRows<T>& rows) HWY_ATTR {
        StoreFirst(d, value, rows.data + n * rows.stride + i, live);
      };
      store(layered.reflectance, arguments.reflectance);
      if constexpr (kDerivatives) {
        store(layered.perEpidermalAbsorption, arguments.perEpidermal);
        store(layered.perDermalAbsorption, arguments.perDermal);
      }
    }
  }
}

template <typename T>
void Dispatch(const ReflectanceArguments<T>& arguments) {
  arguments.perEpidermal.data == nullptr ? Batch<false>(arguments) : Batch<true>(arguments);
}

void BatchFloat(const ReflectanceArguments<float>& arguments) {
  Dispatch(arguments);
}
void BatchDouble(const ReflectanceArguments<double>& arguments) {
  Dispatch(arguments);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(BatchFloat);
HWY_EXPORT(BatchDouble);

template <>
void runReflectanceKernel(const ReflectanceArguments<float>& arguments) {
  HWY_DYNAMIC_DISPATCH(BatchFloat)(arguments);
}

template <>
void runReflectanceKernel(const ReflectanceArguments<double>& arguments) {
  HWY_DYNAMIC_DISPATCH(BatchDouble)(arguments);
}

}  // namespace cutis
#endif  // HWY_ONCE
