#include "core/render/color_difference_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/color_difference_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/maths/cube_root-inl.h"
#include "core/maths/exp-inl.h"
#include "core/maths/partial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A direction in the plane, not necessarily of length 1.
template <class V>
struct Direction {
  V cosine, sine;
};

template <class V>
struct Lab {
  V l, a, b;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE V Hypotenuse(D, V x, V y) {
  return hn::Sqrt(hn::MulAdd(x, x, hn::Mul(y, y)));
}

// x⁷ / (x⁷ + 25⁷), the root of it.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V ChromaShare(D d, V chroma) {
  const V x = hn::Mul(chroma, hn::Set(d, 1.0f / 25.0f));
  const V x2 = hn::Mul(x, x);
  const V x7 = hn::Mul(hn::Mul(hn::Mul(x2, x2), x2), x);
  return hn::Sqrt(hn::Div(x7, hn::Add(x7, hn::Set(d, 1.0f))));
}

// CIELAB's curve, straight below (6/29)³.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V LabCurve(D d, V t) {
  const V line = hn::MulAdd(t, hn::Set(d, 841.0f / 108.0f), hn::Set(d, 4.0f / 29.0f));
  const auto isMissing = hn::IsNaN(t);  // which the root would lose
  const auto isDark = hn::Le(t, hn::Set(d, 216.0f / 24389.0f));
  return hn::IfThenElse(isMissing, t, hn::IfThenElse(isDark, line, CubeRoot(d, t)));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE Lab<V> LabOf(D d, const ColorDifferenceArguments& arguments,
                        const std::array<const float*, 3>& color, std::size_t i, std::size_t live) {
  V rgb[3], f[3];
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = LoadFirst(d, color[c] + i, live);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& row = arguments.toXyz[k];
    V sum = hn::Mul(rgb[0], hn::Set(d, row[0]));
    sum = hn::MulAdd(rgb[1], hn::Set(d, row[1]), sum);
    f[k] = LabCurve(d, hn::MulAdd(rgb[2], hn::Set(d, row[2]), sum));
  }
  return {hn::MulAdd(f[1], hn::Set(d, 116.0f), hn::Set(d, -16.0f)),
          hn::Mul(hn::Sub(f[0], f[1]), hn::Set(d, 500.0f)),
          hn::Mul(hn::Sub(f[1], f[2]), hn::Set(d, 200.0f))};
}

// The direction that is `degrees` further back: the angle's cosine and sine against it.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Direction<V> TurnedBack(D d, const Direction<V>& from, float cosine, float sine) {
  const V c = hn::Set(d, cosine), s = hn::Set(d, sine);
  return {hn::MulAdd(from.cosine, c, hn::Mul(from.sine, s)),
          hn::NegMulAdd(from.cosine, s, hn::Mul(from.sine, c))};
}

// The sum of two angles of unit vectors.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Direction<V> Sum(D, const Direction<V>& a, const Direction<V>& b) {
  return {hn::NegMulAdd(a.sine, b.sine, hn::Mul(a.cosine, b.cosine)),
          hn::MulAdd(a.sine, b.cosine, hn::Mul(a.cosine, b.sine))};
}

// Where the chroma is 0 both are 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Direction<V> Normalized(D d, V x, V y, V length) {
  const V inverse = hn::Div(hn::Set(d, 1.0f), hn::Max(length, hn::Set(d, 1e-9f)));
  return {hn::Mul(x, inverse), hn::Mul(y, inverse)};
}

// The factor T, of the mean hue.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V HueFactor(D d, const Direction<V>& hue) {
  const Direction<V> twice = Sum(d, hue, hue);
  const Direction<V> thrice = Sum(d, twice, hue);
  const Direction<V> fourfold = Sum(d, twice, twice);
  const V by30 = TurnedBack(d, hue, 0.8660254f, 0.5f).cosine;
  const V by6 = TurnedBack(d, thrice, 0.99452190f, -0.10452846f).cosine;
  const V by63 = TurnedBack(d, fourfold, 0.45399050f, 0.89100652f).cosine;
  V t = hn::MulAdd(by30, hn::Set(d, -0.17f), hn::Set(d, 1.0f));
  t = hn::MulAdd(twice.cosine, hn::Set(d, 0.24f), t);
  t = hn::MulAdd(by6, hn::Set(d, 0.32f), t);
  return hn::MulAdd(by63, hn::Set(d, -0.20f), t);
}

// atan on [−1, 1], to 1e-5: Abramowitz and Stegun, 4.4.49.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V Arctangent(D d, V x) {
  const V x2 = hn::Mul(x, x);
  V p = hn::MulAdd(x2, hn::Set(d, 0.0208351f), hn::Set(d, -0.0851330f));
  p = hn::MulAdd(p, x2, hn::Set(d, 0.1801410f));
  p = hn::MulAdd(p, x2, hn::Set(d, -0.3302995f));
  p = hn::MulAdd(p, x2, hn::Set(d, 0.9998660f));
  return hn::Mul(p, x);
}

// sin(2 Δθ), Δθ = 30° exp(−((mean hue − 275°) / 25°)²).
template <class D, class V = hn::Vec<D>>
HWY_INLINE V RotationSine(D d, const Direction<V>& hue) {
  const Direction<V> off = TurnedBack(d, hue, 0.08715574f, -0.99619470f);
  // Beyond a quarter turn the exponential is below 3e-6.
  const V half = hn::Div(off.sine, hn::Add(hn::Set(d, 1.0f), hn::Max(off.cosine, hn::Zero(d))));
  const V quarters = hn::Mul(Arctangent(d, half), hn::Set(d, 2.0f * 57.29578f / 25.0f));
  V share = ExpOfNegative(d, hn::Neg(hn::Mul(quarters, quarters)));
  share = hn::IfThenElseZero(hn::Gt(off.cosine, hn::Zero(d)), share);
  const V y = hn::Mul(share, hn::Set(d, 1.04719755f));
  const V y2 = hn::Mul(y, y);
  V p = hn::MulAdd(y2, hn::Set(d, -1.0f / 5040.0f), hn::Set(d, 1.0f / 120.0f));
  p = hn::MulAdd(p, y2, hn::Set(d, -1.0f / 6.0f));
  p = hn::MulAdd(p, y2, hn::Set(d, 1.0f));
  return hn::Mul(p, y);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V DeltaE2000(D d, const Lab<V>& first, const Lab<V>& second) {
  const V one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
  const V meanChroma =
      hn::Mul(half, hn::Add(Hypotenuse(d, first.a, first.b), Hypotenuse(d, second.a, second.b)));
  const V stretch = hn::NegMulAdd(half, ChromaShare(d, meanChroma), hn::Set(d, 1.5f));
  const V a1 = hn::Mul(first.a, stretch), a2 = hn::Mul(second.a, stretch);
  const V c1 = Hypotenuse(d, a1, first.b), c2 = Hypotenuse(d, a2, second.b);
  const Direction<V> h1 = Normalized(d, a1, first.b, c1), h2 = Normalized(d, a2, second.b, c2);
  const V x = hn::Add(h1.cosine, h2.cosine), y = hn::Add(h1.sine, h2.sine);
  const Direction<V> hue = Normalized(d, x, y, Hypotenuse(d, x, y));

  const V dL = hn::Sub(second.l, first.l);
  const V dC = hn::Sub(c2, c1);
  // The chord between unit vectors is twice the sine of half the angle.
  const V chord = Hypotenuse(d, hn::Sub(h2.cosine, h1.cosine), hn::Sub(h2.sine, h1.sine));
  const V turn = hn::NegMulAdd(h1.sine, h2.cosine, hn::Mul(h1.cosine, h2.sine));
  const V dH = hn::CopySign(hn::Mul(hn::Sqrt(hn::Mul(c1, c2)), chord), turn);

  const V meanC = hn::Mul(half, hn::Add(c1, c2));
  const V above = hn::MulAdd(half, hn::Add(first.l, second.l), hn::Set(d, -50.0f));
  const V above2 = hn::Mul(above, above);
  const V sL = hn::MulAdd(hn::Set(d, 0.015f),
                          hn::Div(above2, hn::Sqrt(hn::Add(above2, hn::Set(d, 20.0f)))), one);
  const V sC = hn::MulAdd(meanC, hn::Set(d, 0.045f), one);
  const V sH = hn::MulAdd(hn::Mul(meanC, hn::Set(d, 0.015f)), HueFactor(d, hue), one);
  const V rT = hn::Mul(hn::Mul(ChromaShare(d, meanC), hn::Set(d, -2.0f)), RotationSine(d, hue));
  const V l = hn::Div(dL, sL), c = hn::Div(dC, sC), h = hn::Div(dH, sH);
  V sum = hn::MulAdd(l, l, hn::Mul(c, c));
  sum = hn::MulAdd(h, h, sum);
  sum = hn::MulAdd(hn::Mul(rT, c), h, sum);
  return hn::Sqrt(hn::Max(sum, hn::Zero(d)));
}

void DifferenceOfRows(const ColorDifferenceArguments& arguments) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t i = 0; i < arguments.count; i += lanes) {
    const std::size_t live = arguments.count - i < lanes ? arguments.count - i : lanes;
    const Lab<V> a = LabOf(d, arguments, arguments.a, i, live);
    const Lab<V> b = LabOf(d, arguments, arguments.b, i, live);
    // Minima and maxima lose what is not a number.
    const V all = hn::Add(hn::Add(a.l, hn::Add(a.a, a.b)), hn::Add(b.l, hn::Add(b.a, b.b)));
    const V difference = hn::IfThenElse(hn::IsNaN(all), all, DeltaE2000(d, a, b));
    StoreFirst(d, difference, arguments.out + i, live);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(DifferenceOfRows);

void runColorDifferenceKernel(const ColorDifferenceArguments& arguments) {
  HWY_DYNAMIC_DISPATCH(DifferenceOfRows)(arguments);
}

}  // namespace cutis
#endif  // HWY_ONCE
