#include "core/maths/weighted_sums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/maths/weighted_sums.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/maths/partial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// kRows rows from `first` on, whose sums stay in registers.
template <std::size_t kRows>
void SumRows(const WeightedSums& arguments, std::size_t first) {
  const hn::ScalableTag<double> d;
  using V = hn::Vec<decltype(d)>;
  const std::size_t lanes = hn::Lanes(d), columns = arguments.columnCount;
  const double* weights = arguments.weights + first * arguments.termCount;
  for (std::size_t i = 0; i < columns; i += lanes) {
    const std::size_t live = columns - i < lanes ? columns - i : lanes;
    V sums[kRows];
    for (V& sum : sums)
      sum = hn::Zero(d);
    for (std::size_t n = 0; n < arguments.termCount; ++n) {
      const V value = LoadFirst(d, arguments.values + n * columns + i, live);
      for (std::size_t r = 0; r < kRows; ++r) {
        sums[r] = hn::MulAdd(hn::Set(d, weights[r * arguments.termCount + n]), value, sums[r]);
      }
    }
    for (std::size_t r = 0; r < kRows; ++r) {
      StoreFirst(d, sums[r], arguments.sums + (first + r) * columns + i, live);
    }
  }
}

void SumAllRows(const WeightedSums& arguments) {
  std::size_t row = 0;
  for (; row + 4 <= arguments.rowCount; row += 4)
    SumRows<4>(arguments, row);
  for (; row < arguments.rowCount; ++row)
    SumRows<1>(arguments, row);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(SumAllRows);

void runWeightedSums(const WeightedSums& arguments) {
  HWY_DYNAMIC_DISPATCH(SumAllRows)(arguments);
}

}  // namespace cutis
#endif  // HWY_ONCE
