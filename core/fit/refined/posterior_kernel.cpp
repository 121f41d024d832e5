#include "core/fit/refined/posterior_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fit/refined/posterior_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/fit/refined/linearise-inl.h"
#include "core/fit/refined/posterior_spread-inl.h"
#include "core/fit/refined/whitening-inl.h"
#include "core/maths/partial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Half the negative gradient of the cost along a coordinate at its bound, the others following,
// where it leads out of the box. Elsewhere an estimate is the lowest point, up to a tolerance.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V OutwardPull(D d, const RefinedProblem<float>& problem, int k, V point, V step,
                         V variance) {
  const V zero = hn::Zero(d);
  const auto below = hn::And(hn::Le(point, hn::Set(d, problem.low[k])), hn::Lt(step, zero));
  const auto above = hn::And(hn::Ge(point, hn::Set(d, problem.high[k])), hn::Gt(step, zero));
  return hn::IfThenElseZero(hn::Or(below, above), hn::Div(step, variance));
}

void Posterior(const RefinedProblem<float>& problem, const PixelRows<const float>& measured,
               const PixelRows<const float>& coordinates, const PixelRows<float>& deviations) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t i = 0; i < measured.count; i += lanes) {
    const std::size_t live = measured.count - i < lanes ? measured.count - i : lanes;
    const auto inside = hn::FirstN(d, live);
    V channels[kMaximumFitChannels];
    V precision[kMaximumFitChannels];
    for (std::size_t k = 0; k < problem.channelCount; ++k) {
      channels[k] = LoadFirst(d, measured.data + k * measured.stride + i, live);
      precision[k] = ChannelPrecision(d, problem, channels[k]);
    }
    V point[kParameterCount];
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      // A parameter that was stored and read again may have left the box by rounding.
      point[k] = hn::Clamp(LoadFirst(d, coordinates.data + k * coordinates.stride + i, live),
                           hn::Set(d, problem.low[k]), hn::Set(d, problem.high[k]));
    }
    V modelled[kMaximumFitChannels][kLinearColumns];
    ModelWithDerivatives(d, problem, PointOf(d, problem, point), modelled);
    if (problem.hasDiscrepancy) {
      V raw[kMaximumFitChannels];
      for (std::size_t k = 0; k < problem.channelCount; ++k)
        raw[k] = channels[k];
      Whitening<V> whitening;
      WhitenMeasured(d, problem, raw, precision, channels, whitening);
      AddExpectedDiscrepancy(d, problem, raw, point, modelled);
      whitening.Apply(d, problem, modelled);
    }
    NormalEquations<V> normal;
    BuildNormalEquations(d, problem, channels, precision, point, modelled, normal);
    for (int k = 0; k < kParameterCount; ++k) {
      if (problem.isFixed[k]) normal.Hold(d, k, inside);
    }
    Factorisation<V> factor;
    normal.Factorise(d, factor);
    V step[kParameterCount];
    factor.Solve(d, normal.downhill, step);
    for (int k = 0; k < kParameterCount; ++k) {
      V unit[kParameterCount];
      for (int j = 0; j < kParameterCount; ++j)
        unit[j] = hn::Set(d, j == k ? 1.0f : 0.0f);
      V column[kParameterCount];
      factor.Solve(d, unit, column);
      V deviation = hn::Zero(d);
      if (!problem.isFixed[k]) {
        const V outward = OutwardPull(d, problem, k, point[k], step[k], column[k]);
        deviation = CoordinatePosterior<decltype(d)>(d, problem, k, point[k], column[k], outward)
                        .Spread(d, hn::Sqrt(column[k]));
      }
      StoreFirst(d, deviation,
                 deviations.data + static_cast<std::size_t>(k) * deviations.stride + i, live);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(Posterior);

void runPosteriorKernel(const RefinedProblem<float>& problem, PixelRows<const float> channels,
                        PixelRows<const float> coordinates, PixelRows<float> deviations) {
  HWY_DYNAMIC_DISPATCH(Posterior)(problem, channels, coordinates, deviations);
}

}  // namespace cutis
#endif  // HWY_ONCE
