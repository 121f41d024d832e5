// The closed form of core/skin/diffusion.h, both layers at once, for a vector of pixels. Included
// once per instruction set (Highway).
//
// With A = 1 at the inner boundaries every exponential is a power of three: g = e^(−s/3) gives
// p = g³ and q_o = g⁴ =: r, q = e^(−s · 4/3 A) and t = e^(−σ_tr d); the half-space needs one more.
// With a = ½ α', C = 1 − t² q r, W = p C and B = a (1 + r)
//
//   R⁺ = a (1 + q)(p² − t² r)/W,  R⁻ = B (p² − t² q)/W,
//   T⁺T⁻ = a (1 + q) B t² (1 − p² q)(1 − p² r)/W²
//
// so that, over a half-space of reflectance R_d and with V = W − B (p² − t² q) R_d,
//
//   R = a (1 + q) [ (p² − t² r) + B t² (1 − p² q)(1 − p² r) R_d / V ] / W.
//
// All reciprocals of one stage come from a single division.

#if defined(CUTIS_CORE_SKIN_DIFFUSION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_SKIN_DIFFUSION_INL_H_
#undef CUTIS_CORE_SKIN_DIFFUSION_INL_H_
#else
#define CUTIS_CORE_SKIN_DIFFUSION_INL_H_
#endif

#include <hwy/highway.h>

#include "core/skin/exp-inl.h"
#include "core/skin/node_constants.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct LayeredVectors {
  V reflectance;
  V perEpidermalAbsorption;  // unset without derivatives
  V perDermalAbsorption;
};

// Epidermal and dermal absorption at a node. melaninEu is C_m · β_m.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void NodeAbsorption(D d, const NodeConstants<hn::TFromD<D>>& node, V melanin,
                               V melaninEu, V bloodDermal, V bloodEpidermal, V carotene,
                               V& epidermal, V& dermal) {
  V sum = hn::MulAdd(melanin, hn::Set(d, node.pheomelanin), hn::Set(d, node.epidermalBase));
  sum = hn::MulAdd(melaninEu, hn::Set(d, node.melaninContrast), sum);
  sum = hn::MulAdd(bloodEpidermal, hn::Set(d, node.epidermalBlood), sum);
  epidermal = hn::MulAdd(carotene, hn::Set(d, node.carotene), sum);
  dermal = hn::MulAdd(bloodDermal, hn::Set(d, node.dermalBlood), hn::Set(d, node.dermalBase));
}

template <bool kDerivatives, class D, class V = hn::Vec<D>>
HWY_INLINE LayeredVectors<V> LayeredReflectanceOf(D d, const LayerConstants<hn::TFromD<D>>& layers,
                                                  const NodeConstants<hn::TFromD<D>>& node,
                                                  V epidermalAbsorption, V dermalAbsorption) {
  using T = hn::TFromD<D>;
  const V one = hn::Set(d, T(1));
  const V scatteringE = hn::Set(d, node.epidermalScattering);
  const V scatteringD = hn::Set(d, node.dermalScattering);
  const V thickness = hn::Set(d, layers.thicknessMm);
  const V gap = hn::Set(d, layers.airGap);

  // Media. u = σ_tr; the absorption floor keeps 1/u finite where a profile absorbs nothing.
  const V floor = hn::Set(d, T(1e-6));
  const V sigmaE = hn::Max(epidermalAbsorption, floor);
  const V sigmaD = hn::Max(dermalAbsorption, floor);
  const V extinctionE = hn::Add(sigmaE, scatteringE);
  const V extinctionD = hn::Add(sigmaD, scatteringD);
  const V three = hn::Set(d, T(3));
  const V uE = hn::Sqrt(hn::Mul(hn::Mul(three, sigmaE), extinctionE));
  const V uD = hn::Sqrt(hn::Mul(hn::Mul(three, sigmaD), extinctionD));
  const V extinctions = hn::Mul(extinctionE, extinctionD);
  const V inverseBoth = hn::Div(one, extinctions);
  const V pathE = hn::Mul(inverseBoth, extinctionD);  // ℓ
  const V pathD = hn::Mul(inverseBoth, extinctionE);
  const V half = hn::Set(d, T(0.5));
  const V aE = hn::Mul(hn::Mul(half, scatteringE), pathE);
  const V aD = hn::Mul(hn::Mul(half, scatteringD), pathD);
  const V sE = hn::Mul(uE, pathE);
  const V sD = hn::Mul(uD, pathD);

  // Exponentials.
  const V third = hn::Set(d, T(-1.0 / 3.0));
  const V gE = ExpOfNegative(d, hn::Mul(sE, third));
  const V gD = ExpOfNegative(d, hn::Mul(sD, third));
  const V q = ExpOfNegative(d, hn::Neg(hn::Mul(sE, gap)));
  const V t = ExpOfNegative(d, hn::Neg(hn::Mul(uE, thickness)));

  // Half-space: R_d = a (p + p r).
  const V gD2 = hn::Mul(gD, gD);
  const V pD = hn::Mul(gD2, gD);
  const V prD = hn::Mul(pD, hn::Mul(gD2, gD2));
  const V below = hn::Mul(aD, hn::Add(pD, prD));

  // Slab.
  const V gE2 = hn::Mul(gE, gE);
  const V p = hn::Mul(gE2, gE);
  const V r = hn::Mul(gE2, gE2);
  const V p2 = hn::Mul(p, p);
  const V t2 = hn::Mul(t, t);
  const V t2q = hn::Mul(t2, q);
  const V t2r = hn::Mul(t2, r);
  const V t2qr = hn::Mul(t2q, r);
  const V p2q = hn::Mul(p2, q);
  const V p2r = hn::Mul(p2, r);
  const V w = hn::Mul(p, hn::Sub(one, t2qr));
  const V up = hn::Sub(p2, t2r);
  const V down = hn::Sub(p2, t2q);
  const V b1 = hn::Sub(one, p2q);
  const V b2 = hn::Sub(one, p2r);
  const V b12 = hn::Mul(b1, b2);
  const V bE = hn::MulAdd(aE, r, aE);       // B
  const V aq = hn::MulAdd(aE, q, aE);       // a (1 + q)
  const V bt2 = hn::Mul(bE, t2);
  const V through = hn::Mul(bt2, b12);      // B t² (1 − p² q)(1 − p² r)
  const V bDown = hn::Mul(bE, down);
  const V v = hn::NegMulAdd(bDown, below, w);
  const V inverseWV = hn::Div(one, hn::Mul(w, v));
  const V inverseW = hn::Mul(inverseWV, v);
  const V inverseV = hn::Mul(inverseWV, w);
  const V k = hn::Mul(below, inverseV);     // R_d / V
  const V inner = hn::MulAdd(through, k, up);
  const V front = hn::Mul(aq, inverseW);
  LayeredVectors<V> result;
  result.reflectance = hn::Mul(front, inner);
  if constexpr (kDerivatives) {
    const V inverseU = hn::Div(one, hn::Mul(uE, uD));
    const V inverseUE = hn::Mul(inverseU, uD);
    const V inverseUD = hn::Mul(inverseU, uE);
    // ds/dσ = 3/2 σ_s'/(σ_t'² u) · … written with α': s' = 3 a ℓ / s, and 1/s = σ_t'/u.
    const V dsE = hn::Mul(hn::Mul(three, aE), inverseUE);
    const V dsD = hn::Mul(hn::Mul(three, aD), inverseUD);
    const V duE = hn::Mul(hn::Mul(hn::Set(d, T(1.5)), hn::Add(extinctionE, sigmaE)), inverseUE);

    // Dermis: dR_d = −ℓ R_d − a (p + 7/3 p r) s'.
    const V seventhirds = hn::Set(d, T(7.0 / 3.0));
    const V falling = hn::Mul(hn::Mul(aD, dsD), hn::MulAdd(seventhirds, prD, pD));
    const V dBelow = hn::NegMulAdd(pathD, below, hn::Neg(falling));
    // ∂R/∂R_d = a (1 + q) B t² (…)(…) / V².
    result.perDermalAbsorption = hn::Mul(
        hn::Mul(aq, through), hn::Mul(hn::Mul(inverseV, inverseV), dBelow));

    // Epidermis, product rule from the inside out.
    const V fourThirds = hn::Set(d, T(4.0 / 3.0));
    const V two = hn::Set(d, T(2));
    const V dDepth2 = hn::Mul(hn::Mul(two, thickness), duE);  // (2 u d)'
    const V gapS = hn::Mul(gap, dsE);
    const V rS = hn::Mul(fourThirds, dsE);
    const V dp2 = hn::Mul(hn::Mul(two, p2), dsE);              // −(p²)'
    const V dUp = hn::MulSub(t2r, hn::Add(dDepth2, rS), dp2);
    const V dDown = hn::MulSub(t2q, hn::Add(dDepth2, gapS), dp2);
    const V twoS = hn::Mul(two, dsE);
    const V dB1 = hn::Mul(p2q, hn::Add(twoS, gapS));
    const V dB2 = hn::Mul(p2r, hn::Add(twoS, rS));
    const V dC = hn::Mul(t2qr, hn::Add(dDepth2, hn::Add(gapS, rS)));
    const V dW = hn::MulSub(p, dC, hn::Mul(w, dsE));
    // B' = −ℓ B − a r rS, (a (1 + q))' = −ℓ a (1 + q) − a q gapS.
    const V dB = hn::Neg(hn::MulAdd(pathE, bE, hn::Mul(hn::Mul(aE, r), rS)));
    const V dAq = hn::Neg(hn::MulAdd(pathE, aq, hn::Mul(hn::Mul(aE, q), gapS)));
    // through' = t² [B' b12 + B (b1' b2 + b1 b2') − B b12 (2ud)']
    V dThrough = hn::MulAdd(dB1, b2, hn::Mul(b1, dB2));
    dThrough = hn::NegMulAdd(b12, dDepth2, dThrough);
    dThrough = hn::Mul(t2, hn::MulAdd(bE, dThrough, hn::Mul(dB, b12)));
    // V' = W' − (B' down + B down') R_d
    const V dV = hn::NegMulAdd(hn::MulAdd(dB, down, hn::Mul(bE, dDown)), below, dW);
    // inner' = up' + k (through' − through V'/V)
    const V dInner = hn::MulAdd(
        k, hn::NegMulAdd(hn::Mul(through, inverseV), dV, dThrough), dUp);
    // R' = (a(1+q))' inner/W + front inner' − R W'/W
    V slope = hn::Mul(front, dInner);
    slope = hn::MulAdd(hn::Mul(dAq, inverseW), inner, slope);
    result.perEpidermalAbsorption =
        hn::NegMulAdd(hn::Mul(result.reflectance, inverseW), dW, slope);
  }
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
