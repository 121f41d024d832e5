// The closed form of core/transport/diffusion.h, both layers at once, for a vector of pixels.
// Included once per instruction set (Highway).
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

#if defined(CUTIS_CORE_SKIN_LAYERS_DIFFUSION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_SKIN_LAYERS_DIFFUSION_INL_H_
#undef CUTIS_CORE_SKIN_LAYERS_DIFFUSION_INL_H_
#else
#define CUTIS_CORE_SKIN_LAYERS_DIFFUSION_INL_H_
#endif

#include <hwy/highway.h>

#include "core/maths/exp-inl.h"
#include "core/skin/layers/node_constants.h"
#include "core/skin/profile/parameter.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct LayeredVectors {
  V reflectance;
  V perEpidermalAbsorption;  // unset without derivatives
  V perDermalAbsorption;
  V perThickness;  // only of LayeredReflectanceAt<true, true>
};

// What absorbs in skin: the parameters, with the amount of eumelanin in place of the blend.
template <class V>
struct AmountVectors {
  V melanin;
  V eumelanin;  // C_m · β_m
  V bloodDermal;
  V bloodEpidermal;
  V carotene;
};
static_assert(
    kParameterCount == 5,
    "a sixth has an amount in AmountVectors, a coefficient in NodeConstants and a term in "
    "NodeAbsorption; its derivative is in core/fit/refined/linearise-inl.h");

// value: a function from the index of a parameter to a vector.
template <class Values>
HWY_INLINE auto AmountsOf(const Values& value) -> AmountVectors<decltype(value(0))> {
  const auto melanin = value(kMelanin);
  return {melanin, hn::Mul(melanin, value(kMelaninBlend)), value(kHaemoglobinDermal),
          value(kHaemoglobinEpidermal), value(kCarotene)};
}

// Epidermal and dermal absorption at a node.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void NodeAbsorption(D d, const NodeConstants<hn::TFromD<D>>& node,
                               const AmountVectors<V>& skin, V& epidermal, V& dermal) {
  V sum = hn::MulAdd(skin.melanin, hn::Set(d, node.pheomelanin), hn::Set(d, node.epidermalBase));
  sum = hn::MulAdd(skin.eumelanin, hn::Set(d, node.melaninContrast), sum);
  sum = hn::MulAdd(skin.bloodEpidermal, hn::Set(d, node.epidermalBlood), sum);
  epidermal = hn::MulAdd(skin.carotene, hn::Set(d, node.carotene), sum);
  dermal = hn::MulAdd(skin.bloodDermal, hn::Set(d, node.dermalBlood), hn::Set(d, node.dermalBase));
}

// A layer as light sees it: the quantities of core/transport/diffusion.h.
template <class V>
struct MediumVectors {
  V absorption, extinction;
  V transport;   // u = σ_tr
  V path;        // ℓ
  V halfAlbedo;  // a
  V argument;    // s
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE MediumVectors<V> MediumOf(D d, V absorption, V scattering, V extinction, V path) {
  using T = hn::TFromD<D>;
  const V transport = hn::Sqrt(hn::Mul(hn::Mul(hn::Set(d, T(3)), absorption), extinction));
  return {absorption,
          extinction,
          transport,
          path,
          hn::Mul(hn::Mul(hn::Set(d, T(0.5)), scattering), path),
          hn::Mul(transport, path)};
}

// Keeps 1/u finite where a profile absorbs nothing.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V PositiveAbsorption(D d, V absorption) {
  return hn::Max(absorption, hn::Set(d, hn::TFromD<D>(1e-6)));
}

// Polynomial with coefficients from the constant upwards, in pairs (Estrin): half the latency of
// Horner's rule, and latency is what bounds these kernels.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V PolynomialOf(D d, const hn::TFromD<D> (&c)[6], V x) {
  const V x2 = hn::Mul(x, x);
  const V low = hn::MulAdd(x, hn::Set(d, c[1]), hn::Set(d, c[0]));
  const V middle = hn::MulAdd(x, hn::Set(d, c[3]), hn::Set(d, c[2]));
  const V high = hn::MulAdd(x, hn::Set(d, c[5]), hn::Set(d, c[4]));
  return hn::MulAdd(hn::MulAdd(high, x2, middle), x2, low);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V PolynomialOf(D d, const hn::TFromD<D> (&c)[7], V x) {
  const V x2 = hn::Mul(x, x);
  const V low = hn::MulAdd(x, hn::Set(d, c[1]), hn::Set(d, c[0]));
  const V middle = hn::MulAdd(x, hn::Set(d, c[3]), hn::Set(d, c[2]));
  const V high =
      hn::MulAdd(x2, hn::Set(d, c[6]), hn::MulAdd(x, hn::Set(d, c[5]), hn::Set(d, c[4])));
  return hn::MulAdd(hn::MulAdd(high, x2, middle), x2, low);
}

// g = e^(−s/3)
template <class D, class V = hn::Vec<D>>
HWY_INLINE V InnerDecay(D d, const LayerConstants<hn::TFromD<D>>& layers, V s) {
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    return PolynomialOf(d, layers.innerDecay, s);
  } else {
    return ExpOfNegative(d, hn::Mul(s, hn::Set(d, hn::TFromD<D>(-1.0 / 3.0))));
  }
}

// q = e^(−s · 4/3 A)
template <class D, class V = hn::Vec<D>>
HWY_INLINE V AirDecay(D d, const LayerConstants<hn::TFromD<D>>& layers, V s) {
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    const V eighth = PolynomialOf(d, layers.airDecay, s);
    const V quarter = hn::Mul(eighth, eighth);
    const V half = hn::Mul(quarter, quarter);
    return hn::Mul(half, half);
  } else {
    return ExpOfNegative(d, hn::Mul(s, hn::Set(d, -layers.airGap)));
  }
}

template <class V>
struct HalfSpaceVectors {
  V reflectance;
  V p, pr;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE HalfSpaceVectors<V> HalfSpaceOf(D d, const LayerConstants<hn::TFromD<D>>& layers,
                                           const MediumVectors<V>& medium) {
  const V g = InnerDecay(d, layers, medium.argument);
  const V g2 = hn::Mul(g, g);
  const V p = hn::Mul(g2, g);
  const V pr = hn::Mul(p, hn::Mul(g2, g2));
  return {hn::Mul(medium.halfAlbedo, hn::Add(p, pr)), p, pr};
}

// The factors of the slab's four optics: R⁺ = front · up / w, R⁻ = back · down / w,
// T⁺T⁻ = front · through / w².
template <class V>
struct SlabVectors {
  V p2, q, r, t2, t2q, t2r, t2qr, p2q, p2r, p;
  V w;     // W
  V up;    // p² − t² r
  V down;  // p² − t² q
  V b1;    // 1 − p² q
  V b2;    // 1 − p² r
  V b12;
  V front;    // a (1 + q)
  V back;     // B = a (1 + r)
  V through;  // B t² b1 b2
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE SlabVectors<V> SlabOf(D d, const LayerConstants<hn::TFromD<D>>& layers,
                                 const MediumVectors<V>& medium, V thickness) {
  using T = hn::TFromD<D>;
  const V one = hn::Set(d, T(1));
  const V s = medium.argument;
  const V g = InnerDecay(d, layers, s);
  const V t = ExpOfNegative(d, hn::Neg(hn::Mul(medium.transport, thickness)));
  const V g2 = hn::Mul(g, g);
  SlabVectors<V> slab;
  slab.q = AirDecay(d, layers, s);
  slab.p = hn::Mul(g2, g);
  slab.r = hn::Mul(g2, g2);
  slab.p2 = hn::Mul(slab.p, slab.p);
  slab.t2 = hn::Mul(t, t);
  slab.t2q = hn::Mul(slab.t2, slab.q);
  slab.t2r = hn::Mul(slab.t2, slab.r);
  slab.t2qr = hn::Mul(slab.t2q, slab.r);
  slab.p2q = hn::Mul(slab.p2, slab.q);
  slab.p2r = hn::Mul(slab.p2, slab.r);
  slab.w = hn::Mul(slab.p, hn::Sub(one, slab.t2qr));
  slab.up = hn::Sub(slab.p2, slab.t2r);
  slab.down = hn::Sub(slab.p2, slab.t2q);
  slab.b1 = hn::Sub(one, slab.p2q);
  slab.b2 = hn::Sub(one, slab.p2r);
  slab.b12 = hn::Mul(slab.b1, slab.b2);
  slab.front = hn::MulAdd(medium.halfAlbedo, slab.q, medium.halfAlbedo);
  slab.back = hn::MulAdd(medium.halfAlbedo, slab.r, medium.halfAlbedo);
  slab.through = hn::Mul(hn::Mul(slab.back, slab.t2), slab.b12);
  return slab;
}

// ∂R/∂d: of all factors t alone depends on the thickness, (t²)' = −2u t².
template <class D, class V = hn::Vec<D>>
HWY_INLINE V ThicknessSlope(D d, const SlabVectors<V>& slab, V transport, V below, V front,
                            V reflectance, V inverseW, V inverseV) {
  const V twice = hn::Mul(hn::Set(d, hn::TFromD<D>(2)), transport);
  const V dW = hn::Mul(hn::Mul(slab.p, slab.t2qr), twice);
  const V dDown = hn::Mul(slab.t2q, twice);
  const V dV = hn::NegMulAdd(hn::Mul(slab.back, dDown), below, dW);
  const V dThrough = hn::Neg(hn::Mul(slab.through, hn::MulAdd(inverseV, dV, twice)));
  const V dInner = hn::MulAdd(hn::Mul(below, inverseV), dThrough, hn::Mul(slab.t2r, twice));
  return hn::NegMulAdd(hn::Mul(reflectance, inverseW), dW, hn::Mul(front, dInner));
}

// thickness: of the epidermis, each pixel's own; kThickness: its derivative, too.
template <bool kDerivatives, bool kThickness, class D, class V = hn::Vec<D>>
HWY_INLINE LayeredVectors<V> LayeredReflectanceAt(D d, const LayerConstants<hn::TFromD<D>>& layers,
                                                  const NodeConstants<hn::TFromD<D>>& node,
                                                  V thickness, V epidermalAbsorption,
                                                  V dermalAbsorption) {
  using T = hn::TFromD<D>;
  const V one = hn::Set(d, T(1));
  const V scatteringE = hn::Set(d, node.epidermalScattering);
  const V scatteringD = hn::Set(d, node.dermalScattering);
  const V sigmaE = PositiveAbsorption(d, epidermalAbsorption);
  const V sigmaD = PositiveAbsorption(d, dermalAbsorption);
  const V extinctionE = hn::Add(sigmaE, scatteringE);
  const V extinctionD = hn::Add(sigmaD, scatteringD);
  const V inverseBoth = hn::Div(one, hn::Mul(extinctionE, extinctionD));
  const MediumVectors<V> epidermis =
      MediumOf(d, sigmaE, scatteringE, extinctionE, hn::Mul(inverseBoth, extinctionD));
  const MediumVectors<V> dermis =
      MediumOf(d, sigmaD, scatteringD, extinctionD, hn::Mul(inverseBoth, extinctionE));

  const HalfSpaceVectors<V> half = HalfSpaceOf(d, layers, dermis);
  const SlabVectors<V> slab = SlabOf(d, layers, epidermis, thickness);
  const V below = half.reflectance;
  const V v = hn::NegMulAdd(hn::Mul(slab.back, slab.down), below, slab.w);
  const V inverseWV = hn::Div(one, hn::Mul(slab.w, v));
  const V inverseW = hn::Mul(inverseWV, v);
  const V inverseV = hn::Mul(inverseWV, slab.w);
  const V k = hn::Mul(below, inverseV);  // R_d / V
  const V inner = hn::MulAdd(slab.through, k, slab.up);
  const V front = hn::Mul(slab.front, inverseW);
  LayeredVectors<V> result;
  result.reflectance = hn::Mul(front, inner);
  if constexpr (kDerivatives) {
    const V three = hn::Set(d, T(3));
    const V inverseU = hn::Div(one, hn::Mul(epidermis.transport, dermis.transport));
    const V inverseUE = hn::Mul(inverseU, dermis.transport);
    const V inverseUD = hn::Mul(inverseU, epidermis.transport);
    // With respect to the layer's own absorption: s' = 3 a ℓ / s = 3 a / u, a' = −ℓ a,
    // u' = 3 (σ_t' + σ_a) / 2u.
    const V dsE = hn::Mul(hn::Mul(three, epidermis.halfAlbedo), inverseUE);
    const V dsD = hn::Mul(hn::Mul(three, dermis.halfAlbedo), inverseUD);
    const V duE = hn::Mul(hn::Mul(hn::Set(d, T(1.5)), hn::Add(extinctionE, sigmaE)), inverseUE);

    // Dermis: R_d' = −ℓ R_d − a (p + 7/3 p r) s' and ∂R/∂R_d = front · through / V².
    const V falling = hn::Mul(hn::Mul(dermis.halfAlbedo, dsD),
                              hn::MulAdd(hn::Set(d, T(7.0 / 3.0)), half.pr, half.p));
    const V dBelow = hn::NegMulAdd(dermis.path, below, hn::Neg(falling));
    result.perDermalAbsorption =
        hn::Mul(hn::Mul(slab.front, slab.through), hn::Mul(hn::Mul(inverseV, inverseV), dBelow));

    // Epidermis: the product rule from the inside out. Exponents first.
    const V dDepth2 = hn::Mul(hn::Add(thickness, thickness), duE);
    const V dGap = hn::Mul(hn::Set(d, layers.airGap), dsE);
    const V dInnerGap = hn::Mul(hn::Set(d, T(4.0 / 3.0)), dsE);
    const V dTwo = hn::Mul(hn::Set(d, T(2)), dsE);
    const V dP2 = hn::Mul(slab.p2, dTwo);  // −(p²)'
    const V dUp = hn::MulSub(slab.t2r, hn::Add(dDepth2, dInnerGap), dP2);
    const V dDown = hn::MulSub(slab.t2q, hn::Add(dDepth2, dGap), dP2);
    const V dB1 = hn::Mul(slab.p2q, hn::Add(dTwo, dGap));
    const V dB2 = hn::Mul(slab.p2r, hn::Add(dTwo, dInnerGap));
    const V dC = hn::Mul(slab.t2qr, hn::Add(dDepth2, hn::Add(dGap, dInnerGap)));
    const V dW = hn::MulSub(slab.p, dC, hn::Mul(slab.w, dsE));
    const V dBack = hn::Neg(hn::MulAdd(epidermis.path, slab.back,
                                       hn::Mul(hn::Mul(epidermis.halfAlbedo, slab.r), dInnerGap)));
    const V dFront = hn::Neg(hn::MulAdd(epidermis.path, slab.front,
                                        hn::Mul(hn::Mul(epidermis.halfAlbedo, slab.q), dGap)));
    // through' = t² [B' b12 + B (b1' b2 + b1 b2' − b12 (2ud)')]
    V dThrough = hn::MulAdd(dB1, slab.b2, hn::Mul(slab.b1, dB2));
    dThrough = hn::NegMulAdd(slab.b12, dDepth2, dThrough);
    dThrough = hn::Mul(slab.t2, hn::MulAdd(slab.back, dThrough, hn::Mul(dBack, slab.b12)));
    // V' = W' − (B' down + B down') R_d
    const V dV = hn::NegMulAdd(hn::MulAdd(dBack, slab.down, hn::Mul(slab.back, dDown)), below, dW);
    // inner' = up' + k (through' − through V'/V)
    const V dInner =
        hn::MulAdd(k, hn::NegMulAdd(hn::Mul(slab.through, inverseV), dV, dThrough), dUp);
    // R' = front' inner/W + front inner'/W − R W'/W
    V slope = hn::Mul(front, dInner);
    slope = hn::MulAdd(hn::Mul(dFront, inverseW), inner, slope);
    result.perEpidermalAbsorption = hn::NegMulAdd(hn::Mul(result.reflectance, inverseW), dW, slope);
  }
  if constexpr (kThickness) {
    result.perThickness = ThicknessSlope(d, slab, epidermis.transport, below, front,
                                         result.reflectance, inverseW, inverseV);
  }
  return result;
}

template <bool kDerivatives, class D, class V = hn::Vec<D>>
HWY_INLINE LayeredVectors<V> LayeredReflectanceOf(D d, const LayerConstants<hn::TFromD<D>>& layers,
                                                  const NodeConstants<hn::TFromD<D>>& node,
                                                  V epidermalAbsorption, V dermalAbsorption) {
  return LayeredReflectanceAt<kDerivatives, false>(d, layers, node, hn::Set(d, layers.thicknessMm),
                                                   epidermalAbsorption, dermalAbsorption);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
