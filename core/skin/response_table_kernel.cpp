#include "core/skin/response_table_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/skin/response_table_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/maths/cube_root-inl.h"
#include "core/maths/exp-inl.h"
#include "core/maths/partial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Where a value lies on an axis: the sample below it and the way to the next, in [0, 1].
template <class D, class V, class VI>
HWY_INLINE void Locate(D d, const ResponseTableAxis& axis, V value, VI& below, V& fraction) {
  const hn::RebindToSigned<D> integers;
  V share = hn::Mul(value, hn::Set(d, axis.inverseMaximum));
  share = hn::Min(hn::Max(share, hn::Zero(d)), hn::Set(d, 1.0f));
  if (axis.exponent == 3) share = hn::Min(CubeRoot(d, share), hn::Set(d, 1.0f));
  if (axis.exponent == 2) share = hn::Sqrt(share);
  const V index = hn::Mul(share, hn::Set(d, axis.intervals));
  const V floor = hn::Min(hn::Floor(index), hn::Set(d, axis.intervals - 1.0f));
  fraction = hn::Sub(index, floor);
  below = hn::ConvertTo(integers, floor);
}

// Puts the larger fraction first, and its axis with it.
template <class D, class V, class VI>
HWY_INLINE void Order(D, V& first, V& second, VI& firstStride, VI& secondStride) {
  const hn::RebindToSigned<D> integers;
  const auto swap = hn::Lt(first, second);
  const auto swapIntegers = hn::RebindMask(integers, swap);
  const V larger = hn::Max(first, second);
  second = hn::Min(first, second);
  first = larger;
  const VI stride = hn::IfThenElse(swapIntegers, secondStride, firstStride);
  secondStride = hn::IfThenElse(swapIntegers, firstStride, secondStride);
  firstStride = stride;
}

// The six corners of the simplex that holds a point, by falling fraction, and their weights.
template <class D, class V, class VI>
HWY_INLINE void FindSimplex(D d, const ResponseTableArguments& arguments, std::size_t i,
                            std::size_t live, VI* corners, V* weights) {
  const hn::RebindToSigned<D> integers;
  V fractions[kParameterCount];
  VI strides[kParameterCount];
  corners[0] = hn::Zero(integers);
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    const V value =
        LoadFirst(d, arguments.parameters.data + k * arguments.parameters.stride + i, live);
    VI below;
    Locate(d, arguments.axes[k], value, below, fractions[k]);
    strides[k] = hn::Set(integers, arguments.axes[k].stride);
    corners[0] = hn::Add(corners[0], hn::Mul(below, strides[k]));
  }
  // A network that sorts five.
  static_assert(kParameterCount == 5, "a sixth parameter needs another sorting network");
  constexpr std::size_t kPairs[][2] = {{0, 1}, {3, 4}, {2, 4}, {2, 3}, {1, 4},
                                       {0, 3}, {0, 2}, {1, 3}, {1, 2}};
  for (const auto& pair : kPairs) {
    Order(d, fractions[pair[0]], fractions[pair[1]], strides[pair[0]], strides[pair[1]]);
  }
  weights[0] = hn::Sub(hn::Set(d, 1.0f), fractions[0]);
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    corners[k + 1] = hn::Add(corners[k], strides[k]);
    weights[k + 1] =
        k + 1 < kParameterCount ? hn::Sub(fractions[k], fractions[k + 1]) : fractions[k];
  }
}

void InterpolateTable(const ResponseTableArguments& arguments) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> integers;
  using V = hn::Vec<decltype(d)>;
  using VI = hn::Vec<decltype(integers)>;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t count = arguments.parameters.count;
  for (std::size_t i = 0; i < count; i += lanes) {
    const std::size_t live = count - i < lanes ? count - i : lanes;
    VI corners[kParameterCount + 1];
    V weights[kParameterCount + 1];
    FindSimplex(d, arguments, i, live, corners, weights);
    for (std::size_t row = 0; row < arguments.rowCount; ++row) {
      V sum = hn::Zero(d);
      for (std::size_t k = 0; k <= kParameterCount; ++k) {
        sum = hn::MulAdd(weights[k], hn::GatherIndex(d, arguments.samples + row, corners[k]), sum);
      }
      StoreFirst(d, ExpOfNegative(d, sum), arguments.out[row] + i, live);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(InterpolateTable);

void runResponseTableKernel(const ResponseTableArguments& arguments) {
  HWY_DYNAMIC_DISPATCH(InterpolateTable)(arguments);
}

}  // namespace cutis
#endif  // HWY_ONCE
