// The polynomial of core/skin/layers/polynomial.h and its derivatives, for a vector of pixels.
// Included once per instruction set (Highway).
//
// No branch and no gather: all lanes share the coefficients. Horner's rule in z_e runs over the
// five columns at once, values and slopes side by side, so that the chains hide each other's
// latency; the columns then meet in z_d. About 130 operations with derivatives, 70 without.
//
// Absorption outside its range is taken as the nearest end's: value and slopes of the edge. NaN in
// a lane stays in that lane.

#if defined(CUTIS_CORE_SKIN_LAYERS_TABLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_SKIN_LAYERS_TABLE_INL_H_
#undef CUTIS_CORE_SKIN_LAYERS_TABLE_INL_H_
#else
#define CUTIS_CORE_SKIN_LAYERS_TABLE_INL_H_
#endif

#include <hwy/highway.h>

#include "core/skin/layers/diffusion-inl.h"
#include "core/skin/layers/polynomial.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// √ of the absorption, brought into its range.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V RootWithin(D d, const AbsorptionScale<hn::TFromD<D>>& layer, V absorption) {
  return hn::Sqrt(hn::Min(hn::Set(d, layer.high), hn::Max(hn::Set(d, layer.low), absorption)));
}

// One step of Horner's rule in every column.
template <bool kDerivatives, class D, class V = hn::Vec<D>>
HWY_INLINE void NextPower(D d, const hn::TFromD<D> (&row)[kDermalTerms], V z, V& p0, V& p1, V& p2,
                          V& p3, V& p4, V& s0, V& s1, V& s2, V& s3, V& s4) {
  if constexpr (kDerivatives) {
    s0 = hn::MulAdd(s0, z, p0);
    s1 = hn::MulAdd(s1, z, p1);
    s2 = hn::MulAdd(s2, z, p2);
    s3 = hn::MulAdd(s3, z, p3);
    s4 = hn::MulAdd(s4, z, p4);
  }
  p0 = hn::MulAdd(p0, z, hn::Set(d, row[0]));
  p1 = hn::MulAdd(p1, z, hn::Set(d, row[1]));
  p2 = hn::MulAdd(p2, z, hn::Set(d, row[2]));
  p3 = hn::MulAdd(p3, z, hn::Set(d, row[3]));
  p4 = hn::MulAdd(p4, z, hn::Set(d, row[4]));
}

// c0 + c1 z + … + c4 z⁴ in pairs.
template <class V>
HWY_INLINE V AcrossColumns(V z, V z2, V c0, V c1, V c2, V c3, V c4) {
  const V low = hn::MulAdd(c1, z, c0);
  const V high = hn::MulAdd(c3, z, c2);
  return hn::MulAdd(hn::MulAdd(c4, z2, high), z2, low);
}

// z of one layer.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V PolynomialVariable(D d, const AbsorptionScale<hn::TFromD<D>>& layer, V absorption) {
  const V sum = hn::Add(RootWithin(d, layer, absorption), hn::Set(d, layer.knee));
  return hn::Sub(hn::Set(d, layer.end), hn::Div(hn::Set(d, layer.span), sum));
}

// The polynomial in z_d that one epidermis leaves: columns[j] goes with z_dʲ.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void ColumnsOf(D d, const LayerPolynomial<hn::TFromD<D>>& table, V epidermalAbsorption,
                          V* columns) {
  const V z = PolynomialVariable(d, table.epidermis, epidermalAbsorption);
  for (int j = 0; j < kDermalTerms; ++j) {
    V sum = hn::Set(d, table.coefficients[kEpidermalTerms - 1][j]);
    for (int i = kEpidermalTerms - 2; i >= 0; --i) {
      sum = hn::MulAdd(sum, z, hn::Set(d, table.coefficients[i][j]));
    }
    columns[j] = sum;
  }
}

template <bool kDerivatives, class D, class V = hn::Vec<D>>
HWY_INLINE LayeredVectors<V> TabulatedReflectanceOf(D d,
                                                    const LayerPolynomial<hn::TFromD<D>>& table,
                                                    V epidermalAbsorption, V dermalAbsorption) {
  using T = hn::TFromD<D>;
  static_assert(kDermalTerms == 5);
  const V rootE = RootWithin(d, table.epidermis, epidermalAbsorption);
  const V rootD = RootWithin(d, table.dermis, dermalAbsorption);
  const V sumE = hn::Add(rootE, hn::Set(d, table.epidermis.knee));
  const V sumD = hn::Add(rootD, hn::Set(d, table.dermis.knee));
  const V inverse = hn::Div(hn::Set(d, T(1)), hn::Mul(sumE, sumD));
  const V inverseE = hn::Mul(inverse, sumD);
  const V inverseD = hn::Mul(inverse, sumE);
  const V spanE = hn::Set(d, table.epidermis.span);
  const V spanD = hn::Set(d, table.dermis.span);
  const V z = hn::NegMulAdd(inverseE, spanE, hn::Set(d, table.epidermis.end));
  const V y = hn::NegMulAdd(inverseD, spanD, hn::Set(d, table.dermis.end));
  const V y2 = hn::Mul(y, y);

  // The two highest powers at once: the slope of the first step is the leading coefficient.
  const auto& last = table.coefficients[kEpidermalTerms - 1];
  const auto& next = table.coefficients[kEpidermalTerms - 2];
  V s0 = hn::Set(d, last[0]), s1 = hn::Set(d, last[1]), s2 = hn::Set(d, last[2]);
  V s3 = hn::Set(d, last[3]), s4 = hn::Set(d, last[4]);
  V p0 = hn::MulAdd(s0, z, hn::Set(d, next[0])), p1 = hn::MulAdd(s1, z, hn::Set(d, next[1]));
  V p2 = hn::MulAdd(s2, z, hn::Set(d, next[2])), p3 = hn::MulAdd(s3, z, hn::Set(d, next[3]));
  V p4 = hn::MulAdd(s4, z, hn::Set(d, next[4]));
  HWY_UNROLL(8)
  for (int i = kEpidermalTerms - 3; i >= 0; --i) {
    NextPower<kDerivatives>(d, table.coefficients[i], z, p0, p1, p2, p3, p4, s0, s1, s2, s3, s4);
  }
  LayeredVectors<V> result;
  result.reflectance = AcrossColumns(y, y2, p0, p1, p2, p3, p4);
  if constexpr (kDerivatives) {
    const V inverseRoots = hn::Div(hn::Set(d, T(0.5)), hn::Mul(rootE, rootD));
    const V dz = hn::Mul(hn::Mul(inverseRoots, rootD), hn::Mul(hn::Mul(inverseE, inverseE), spanE));
    const V dy = hn::Mul(hn::Mul(inverseRoots, rootE), hn::Mul(hn::Mul(inverseD, inverseD), spanD));
    result.perEpidermalAbsorption = hn::Mul(AcrossColumns(y, y2, s0, s1, s2, s3, s4), dz);
    // p1 + 2 p2 y + 3 p3 y² + 4 p4 y³
    const V low = hn::MulAdd(hn::Add(p2, p2), y, p1);
    const V high = hn::MulAdd(hn::Mul(p4, hn::Set(d, T(4))), y, hn::Mul(p3, hn::Set(d, T(3))));
    const V slope = hn::MulAdd(high, y2, low);
    result.perDermalAbsorption = hn::Mul(slope, dy);
  }
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
