#include "core/fit/table/table_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fit/table/table_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/skin/layers/node_reflectance-inl.h"

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
    float* out = arguments.dermis + n * arguments.dermalStride;
    for (std::size_t i = 0; i < arguments.dermalStride; i += hn::Lanes(d)) {
      const V blood = hn::LoadU(d, arguments.dermalBlood + i);
      const V absorption = PositiveAbsorption(
          d, hn::MulAdd(blood, hn::Set(d, node.dermalBlood), hn::Set(d, node.dermalBase)));
      if (node.transport != nullptr) {
        hn::StoreU(PolynomialVariable(d, node.transport->dermis, absorption), d, out + i);
        continue;
      }
      const V extinction = hn::Add(absorption, scattering);
      const V path = hn::Div(hn::Set(d, 1.0f), extinction);
      const HalfSpaceVectors<V> half =
          HalfSpaceOf(d, arguments.layers, MediumOf(d, absorption, scattering, extinction, path));
      hn::StoreU(half.reflectance, d, out + i);
    }
  }
}

// One epidermis at every node; one lane each, since the table has far fewer
// slabs than adding steps.
void Epidermis(const TableArguments& arguments) {
  const hn::CappedTag<float, 1> d;
  using V = hn::Vec<decltype(d)>;
  const AmountVectors<V> skin = {
      hn::Set(d, arguments.melanin), hn::Set(d, arguments.melanin * arguments.blend), hn::Zero(d),
      hn::Set(d, arguments.epidermalBlood), hn::Set(d, arguments.carotene)};
  for (std::size_t n = 0; n < arguments.nodeCount; ++n) {
    const NodeConstants<float>& node = arguments.nodes[n];
    V epidermal, dermal;
    NodeAbsorption(d, node, skin, epidermal, dermal);
    const V absorption = PositiveAbsorption(d, epidermal);
    float* out = arguments.scratch + kEpidermisNumbers * n;
    if (node.transport != nullptr) {
      V columns[kDermalTerms];
      ColumnsOf(d, *node.transport, absorption, columns);
      for (std::size_t j = 0; j < kDermalTerms; ++j)
        out[j] = hn::GetLane(columns[j]);
      continue;
    }
    const V scattering = hn::Set(d, node.epidermalScattering);
    const V extinction = hn::Add(absorption, scattering);
    const V path = hn::Div(hn::Set(d, 1.0f), extinction);
    const SlabVectors<V> slab =
        SlabOf(d, arguments.layers, MediumOf(d, absorption, scattering, extinction, path),
               hn::Set(d, arguments.layers.thicknessMm));
    const V inverseW = hn::Div(hn::Set(d, 1.0f), slab.w);
    const V front = hn::Mul(slab.front, inverseW);
    out[0] = hn::GetLane(hn::Mul(front, slab.up));
    out[1] = hn::GetLane(hn::Mul(hn::Mul(slab.back, slab.down), inverseW));
    out[2] = hn::GetLane(hn::Mul(hn::Mul(front, slab.through), inverseW));
  }
}

// An epidermis over a vector of dermises: Kubelka–Munk adding, or the polynomial.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V OverDermis(D d, const NodeConstants<float>& node, const float* epidermis, V dermis) {
  if (node.transport != nullptr) {
    return AcrossColumns(dermis, hn::Mul(dermis, dermis), hn::Set(d, epidermis[0]),
                         hn::Set(d, epidermis[1]), hn::Set(d, epidermis[2]),
                         hn::Set(d, epidermis[3]), hn::Set(d, epidermis[4]));
  }
  const V gap = hn::NegMulAdd(hn::Set(d, epidermis[1]), dermis, hn::Set(d, 1.0f));
  return hn::Add(hn::Set(d, epidermis[0]), hn::Div(hn::Mul(hn::Set(d, epidermis[2]), dermis), gap));
}

// Summed into kRows rows at once; kRows is a constant so that the sums stay
// in registers.
template <std::size_t kRows>
void Add(const TableArguments& arguments, std::size_t firstRow) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  for (std::size_t i = 0; i < arguments.dermalStride; i += hn::Lanes(d)) {
    V sums[kRows];
    for (V& sum : sums)
      sum = hn::Zero(d);
    const float* dermis = arguments.dermis + i;
    const float* epidermis = arguments.scratch;
    const float* weights = arguments.weights + firstRow;
    for (std::size_t n = 0; n < arguments.nodeCount; ++n) {
      const V reflectance = OverDermis(d, arguments.nodes[n], epidermis, hn::LoadU(d, dermis));
      for (std::size_t k = 0; k < kRows; ++k) {
        sums[k] = hn::MulAdd(reflectance, hn::Set(d, weights[k]), sums[k]);
      }
      dermis += arguments.dermalStride;
      epidermis += kEpidermisNumbers;
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
  for (; row + 8 <= arguments.rowCount; row += 8)
    Add<8>(arguments, row);
  for (; row + 4 <= arguments.rowCount; row += 4)
    Add<4>(arguments, row);
  for (; row < arguments.rowCount; ++row)
    Add<1>(arguments, row);
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

void runTableKernel(const TableArguments& arguments) {
  HWY_DYNAMIC_DISPATCH(Table)(arguments);
}

}  // namespace cutis
#endif  // HWY_ONCE
