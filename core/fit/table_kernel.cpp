#include "core/fit/table_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fit/table_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/skin/diffusion-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void Dermis(const TableArguments& arguments) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  for (std::size_t n = 0; n < arguments.nodeCount; ++n) {
    const NodeConstants<float>& node = arguments.nodes[n];
    const V scattering = hn::Set(d, node.dermalScattering);
    for (std::size_t i = 0; i < arguments.dermalStride; i += hn::Lanes(d)) {
      const V blood = hn::LoadU(d, arguments.dermalBlood + i);
      const V absorption = PositiveAbsorption(
          d, hn::MulAdd(blood, hn::Set(d, node.dermalBlood), hn::Set(d, node.dermalBase)));
      const V extinction = hn::Add(absorption, scattering);
      const V path = hn::Div(hn::Set(d, 1.0f), extinction);
      const HalfSpaceVectors<V> half =
          HalfSpaceOf(d, arguments.layers, MediumOf(d, absorption, scattering, extinction, path));
      hn::StoreU(half.reflectance, d,
                 arguments.dermalReflectance + n * arguments.dermalStride + i);
    }
  }
}

// R⁺, R⁻ and T⁺T⁻ of one epidermis at every node; one lane each, since the table has far fewer
// slabs than adding steps.
void Epidermis(const TableArguments& arguments) {
  const hn::CappedTag<float, 1> d;
  using V = hn::Vec<decltype(d)>;
  const float melaninEu = arguments.melanin * arguments.blend;
  for (std::size_t n = 0; n < arguments.nodeCount; ++n) {
    const NodeConstants<float>& node = arguments.nodes[n];
    V epidermal, dermal;
    NodeAbsorption(d, node, hn::Set(d, arguments.melanin), hn::Set(d, melaninEu), hn::Zero(d),
                   hn::Set(d, arguments.epidermalBlood), hn::Set(d, arguments.carotene), epidermal,
                   dermal);
    const V absorption = PositiveAbsorption(d, epidermal);
    const V scattering = hn::Set(d, node.epidermalScattering);
    const V extinction = hn::Add(absorption, scattering);
    const V path = hn::Div(hn::Set(d, 1.0f), extinction);
    const SlabVectors<V> slab =
        SlabOf(d, arguments.layers, MediumOf(d, absorption, scattering, extinction, path));
    const V inverseW = hn::Div(hn::Set(d, 1.0f), slab.w);
    const V front = hn::Mul(slab.front, inverseW);
    float* out = arguments.scratch + 3 * n;
    out[0] = hn::GetLane(hn::Mul(front, slab.up));
    out[1] = hn::GetLane(hn::Mul(hn::Mul(slab.back, slab.down), inverseW));
    out[2] = hn::GetLane(hn::Mul(hn::Mul(front, slab.through), inverseW));
  }
}

// Kubelka–Munk adding, summed into kRows rows at once; kRows is a constant so that the sums stay
// in registers.
template <std::size_t kRows>
void Add(const TableArguments& arguments, std::size_t firstRow) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const V one = hn::Set(d, 1.0f);
  for (std::size_t i = 0; i < arguments.dermalStride; i += hn::Lanes(d)) {
    V sums[kRows];
    for (V& sum : sums) sum = hn::Zero(d);
    const float* below = arguments.dermalReflectance + i;
    const float* slab = arguments.scratch;
    const float* weights = arguments.weights + firstRow;
    for (std::size_t n = 0; n < arguments.nodeCount; ++n) {
      const V r = hn::LoadU(d, below);
      const V gap = hn::NegMulAdd(hn::Set(d, slab[1]), r, one);
      const V reflectance =
          hn::Add(hn::Set(d, slab[0]), hn::Div(hn::Mul(hn::Set(d, slab[2]), r), gap));
      for (std::size_t k = 0; k < kRows; ++k) {
        sums[k] = hn::MulAdd(reflectance, hn::Set(d, weights[k]), sums[k]);
      }
      below += arguments.dermalStride;
      slab += 3;
      weights += kMaximumTableRows;
    }
    for (std::size_t k = 0; k < kRows; ++k) {
      hn::StoreU(sums[k], d, arguments.out + (firstRow + k) * arguments.dermalStride + i);
    }
  }
}

void Table(const TableArguments& arguments) {
  Epidermis(arguments);
  std::size_t row = 0;
  for (; row + 8 <= arguments.rowCount; row += 8) Add<8>(arguments, row);
  for (; row + 4 <= arguments.rowCount; row += 4) Add<4>(arguments, row);
  for (; row < arguments.rowCount; ++row) Add<1>(arguments, row);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(Dermis);
HWY_EXPORT(Table);

std::size_t roundUpToTableLanes(std::size_t count) {
  constexpr std::size_t widest = 16;
  return (count + widest - 1) / widest * widest;
}

void runDermisKernel(const TableArguments& arguments) {
  HWY_DYNAMIC_DISPATCH(Dermis)(arguments);
}

void runTableKernel(const TableArguments& arguments) { HWY_DYNAMIC_DISPATCH(Table)(arguments); }

}  // namespace cutis
#endif  // HWY_ONCE
