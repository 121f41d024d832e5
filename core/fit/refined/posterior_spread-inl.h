// Spread of one coordinate where the posterior need not be normal. Included once per instruction
// set (Highway).

#if defined(CUTIS_CORE_FIT_REFINED_POSTERIOR_SPREAD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_FIT_REFINED_POSTERIOR_SPREAD_INL_H_
#undef CUTIS_CORE_FIT_REFINED_POSTERIOR_SPREAD_INL_H_
#else
#define CUTIS_CORE_FIT_REFINED_POSTERIOR_SPREAD_INL_H_
#endif

#include <hwy/highway.h>

#include "core/fit/refined/refined_kernel.h"
#include "core/maths/exp-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Along one coordinate x, the others following: the data are normal in what they respond to, u(x),
// the concentration C itself or √(C + c); the prior is normal in x, and the box cuts both off.
// Where x is a logarithm or u a root and little is known, that is far from a normal curve in x:
// seen from a high estimate, a low concentration is one long tail.
template <class D, class V = hn::Vec<D>>
class CoordinatePosterior {
  using T = hn::TFromD<D>;

 public:
  // variance: of x in the normal approximation, the prior included. downhill: half the negative
  // gradient of the cost along x at the estimate; not zero at a bound.
  HWY_INLINE CoordinatePosterior(D d, const RefinedProblem<T>& problem, int coordinate, V estimate,
                                 V variance, V downhill)
      : problem_(problem), coordinate_(coordinate), estimate_(estimate) {
    priorPrecision_ =
        T(1) / (problem.priorDeviation[coordinate] * problem.priorDeviation[coordinate]);
    const V precision = hn::Set(d, priorPrecision_);
    fromMean_ = hn::Sub(estimate, hn::Set(d, problem.priorMean[coordinate]));
    const V ofData =
        hn::Max(hn::Sub(hn::Div(hn::Set(d, T(1)), variance), precision), hn::Set(d, T(1e-6)));
    responseAtEstimate_ = Response(d, estimate);
    const V slope = ResponseSlope(d, estimate);
    curvature_ = hn::Div(ofData, hn::Mul(slope, slope));
    pull_ = hn::Div(hn::MulAdd(precision, fromMean_, downhill), slope);
  }

  // Root mean square distance from the estimate. `deviation`: √variance.
  HWY_INLINE V Spread(D d, V deviation) const {
    // Fine steps at the estimate, and wide enough for the prior's own tails.
    const V reach = hn::Max(
        hn::Set(d, kLeast),
        hn::Min(hn::Set(d, kMost),
                hn::Div(hn::Set(d, T(4) * problem_.priorDeviation[coordinate_]), deviation)));
    const V below = hn::Sub(estimate_, hn::Set(d, problem_.low[coordinate_]));
    const V above = hn::Sub(hn::Set(d, problem_.high[coordinate_]), estimate_);
    Moments moments = {hn::Zero(d), hn::Zero(d)};
    AddSide(d, reach, hn::Min(hn::Mul(deviation, reach), below), T(-1), moments);
    AddSide(d, reach, hn::Min(hn::Mul(deviation, reach), above), T(1), moments);
    // An estimate lies in its range, which is more than a point, so that the mass is never nothing.
    return hn::Sqrt(hn::Div(moments.second, moments.mass));
  }

 private:
  // The steps x(t) = s (3 t + (r − 3) t³), 0 ≤ t ≤ 1, end at r s, which is r deviations or the end
  // of the range, whichever is nearer: no step falls out of the range as the estimate moves.
  static constexpr int kSteps = 16;
  static constexpr T kLinear = T(3);
  static constexpr T kLeast = T(5);
  static constexpr T kMost = T(32);

  struct Moments {
    V mass, second;
  };

  HWY_INLINE void AddSide(D d, V reach, V length, T direction, Moments& moments) const {
    const V scale = hn::Div(length, reach);
    const V cubic = hn::Sub(reach, hn::Set(d, kLinear));
    for (int j = 0; j <= kSteps; ++j) {
      const T t = static_cast<T>(j) / T(kSteps);
      const T half = j == 0 || j == kSteps ? T(0.5) : T(1);
      const V away = hn::Mul(hn::Mul(scale, hn::Set(d, direction)),
                             hn::MulAdd(cubic, hn::Set(d, t * t * t), hn::Set(d, kLinear * t)));
      const V width =
          hn::Mul(scale, hn::MulAdd(cubic, hn::Set(d, T(3) * t * t), hn::Set(d, kLinear)));
      const V density = Density(d, hn::Add(estimate_, away), away);
      const V share = hn::Mul(hn::Mul(width, hn::Set(d, half)), density);
      moments.mass = hn::Add(moments.mass, share);
      moments.second = hn::MulAdd(hn::Mul(share, away), away, moments.second);
    }
  }

  HWY_INLINE V Concentration(D d, V x) const {
    return problem_.isLog[coordinate_] ? ExpOfNegative(d, hn::Min(x, hn::Zero(d))) : x;
  }
  HWY_INLINE V Response(D d, V x) const {
    const V concentration = Concentration(d, x);
    const T offset = problem_.rootOffset[coordinate_];
    if (offset == T(0)) return concentration;
    return hn::Sqrt(hn::Max(hn::Add(concentration, hn::Set(d, offset)), hn::Zero(d)));
  }
  HWY_INLINE V ResponseSlope(D d, V x) const {
    const V one = hn::Set(d, T(1));
    const V inner = problem_.isLog[coordinate_] ? Concentration(d, x) : one;
    if (problem_.rootOffset[coordinate_] == T(0)) return inner;
    return hn::Div(inner, hn::Mul(hn::Set(d, T(2)), Response(d, x)));
  }

  // Relative to the estimate's.
  HWY_INLINE V Density(D d, V x, V away) const {
    const V half = hn::Set(d, T(0.5));
    const V change = hn::Sub(Response(d, x), responseAtEstimate_);
    const V data = hn::Mul(change, hn::NegMulAdd(hn::Mul(half, curvature_), change, pull_));
    const V precision = hn::Set(d, priorPrecision_);
    const V prior = hn::Mul(hn::Mul(precision, away), hn::MulAdd(half, away, fromMean_));
    return ExpOfNegative(d, hn::Min(hn::Sub(data, prior), hn::Set(d, T(40))));
  }

  const RefinedProblem<T>& problem_;
  const int coordinate_;
  T priorPrecision_;
  V estimate_, fromMean_, responseAtEstimate_;
  V curvature_;  // of the data's cost, along the response
  V pull_;       // of the data at the estimate, along the response
};

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
