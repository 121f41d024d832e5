#include "core/skin/response_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/skin/response_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/maths/partial-inl.h"
#include "core/skin/layers/node_reflectance-inl.h"
#include "core/skin/profile/discrepancy_size.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// kCoefficients: whether there are any.
template <std::size_t kRows, bool kCoefficients>
HWY_NOINLINE void Respond(const ResponseArguments& arguments) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const std::size_t lanes = hn::Lanes(d);
  const PixelRows<const float> parameters = arguments.parameters;
  for (std::size_t i = 0; i < parameters.count; i += lanes) {
    const std::size_t live = parameters.count - i < lanes ? parameters.count - i : lanes;
    const auto load = [&](std::size_t k) HWY_ATTR {
      return LoadFirst(d, parameters.data + k * parameters.stride + i, live);
    };
    const AmountVectors<V> skin = AmountsOf(load);
    V coefficients[kMaximumCoefficients];
    if constexpr (kCoefficients) {
      for (std::size_t c = 0; c < arguments.coefficients.rowCount; ++c) {
        coefficients[c] =
            LoadFirst(d, arguments.coefficients.data + c * arguments.coefficients.stride + i, live);
      }
    }
    V sums[kRows];
    for (V& sum : sums)
      sum = hn::Zero(d);
    const float* weights = arguments.weights;
    for (std::size_t n = 0; n < arguments.nodeCount; ++n) {
      V epidermal, dermal;
      NodeAbsorption(d, arguments.nodes[n], skin, epidermal, dermal);
      const V reflectance =
          NodeReflectanceOf<false>(d, arguments.layers, arguments.nodes[n], epidermal, dermal)
              .reflectance;
      for (std::size_t k = 0; k < kRows; ++k) {
        V weight = hn::Set(d, weights[k]);
        if constexpr (kCoefficients) {
          const float* more = weights + k;
          for (std::size_t c = 0; c < arguments.coefficients.rowCount; ++c) {
            more += arguments.coefficientStride;
            weight = hn::MulAdd(coefficients[c], hn::Set(d, *more), weight);
          }
        }
        sums[k] = hn::MulAdd(reflectance, weight, sums[k]);
      }
      weights += arguments.weightStride;
    }
    for (std::size_t k = 0; k < kRows; ++k) {
      StoreFirst(d, sums[k], arguments.out[k] + i, live);
    }
  }
}

template <bool kCoefficients>
void RespondRows(const ResponseArguments& arguments) {
  switch (arguments.rowCount) {
    case 1:
      return Respond<1, kCoefficients>(arguments);
    case 2:
      return Respond<2, kCoefficients>(arguments);
    case 3:
      return Respond<3, kCoefficients>(arguments);
    default:
      return Respond<4, kCoefficients>(arguments);
  }
}

void RespondAny(const ResponseArguments& arguments) {
  arguments.coefficients.rowCount > 0 ? RespondRows<true>(arguments)
                                      : RespondRows<false>(arguments);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(RespondAny);

void runResponseKernel(const ResponseArguments& arguments) {
  HWY_DYNAMIC_DISPATCH(RespondAny)(arguments);
}

}  // namespace cutis
#endif  // HWY_ONCE
