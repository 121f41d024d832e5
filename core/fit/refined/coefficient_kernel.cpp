#include "core/fit/refined/coefficient_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fit/refined/coefficient_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/fit/refined/linearise-inl.h"
#include "core/fit/refined/whitening-inl.h"
#include "core/maths/partial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// y ∘ Σ⁻¹ (y − modelled), a value per channel.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void WeighedResiduals(D d, const RefinedProblem<float>& problem, const V* measured,
                                 const V* point, V (*weighed)[1]) {
  V precision[kMaximumFitChannels], white[kMaximumFitChannels];
  for (std::size_t k = 0; k < problem.channelCount; ++k)
    precision[k] = ChannelPrecision(d, problem, measured[k]);
  Whitening<V> whitening;
  WhitenMeasured(d, problem, measured, precision, white, whitening);
  ModelOnly(d, problem, PointOf(d, problem, point), weighed);
  AddExpectedDiscrepancy(d, problem, measured, point, weighed);
  whitening.Apply(d, problem, weighed);
  V shading = hn::Set(d, 1.0f);
  if (problem.shadingPrecision > 0.0f)
    shading = ShadingOf(d, problem, white, precision, weighed).factor;
  for (std::size_t k = 0; k < problem.channelCount; ++k)
    weighed[k][0] = hn::NegMulAdd(shading, weighed[k][0], white[k]);
  whitening.ApplyTransposed(d, problem, weighed);
  for (std::size_t k = 0; k < problem.channelCount; ++k)
    weighed[k][0] = hn::Mul(weighed[k][0], measured[k]);
}

void Coefficients(const RefinedProblem<float>& problem, const CoefficientProblem& line,
                  const PixelRows<const float>& channels, const PixelRows<const float>& coordinates,
                  const PixelRows<float>& coefficients) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t i = 0; i < channels.count; i += lanes) {
    const std::size_t live = channels.count - i < lanes ? channels.count - i : lanes;
    V measured[kMaximumFitChannels];
    for (std::size_t k = 0; k < problem.channelCount; ++k)
      measured[k] = LoadFirst(d, channels.data + k * channels.stride + i, live);
    V point[kParameterCount];
    for (std::size_t k = 0; k < kParameterCount; ++k)
      point[k] = LoadFirst(d, coordinates.data + k * coordinates.stride + i, live);
    V weighed[kMaximumFitChannels][1];
    WeighedResiduals(d, problem, measured, point, weighed);
    V found[kMaximumCoefficients];
    V square = hn::Zero(d);
    for (std::size_t c = 0; c < line.count; ++c) {
      V sum = hn::Set(d, line.offset[c]);
      for (std::size_t p = 0; p < kParameterCount; ++p)
        sum = hn::MulAdd(hn::Set(d, line.slope[c][p]), point[p], sum);
      for (std::size_t k = 0; k < problem.channelCount; ++k)
        sum = hn::MulAdd(hn::Set(d, line.gain[c][k]), weighed[k][0], sum);
      found[c] = sum;
      square = hn::MulAdd(sum, sum, square);
    }
    const V most = hn::Set(d, static_cast<float>(kMostCoefficientNorm));
    const V share = hn::Min(hn::Set(d, 1.0f), hn::Div(most, hn::Sqrt(square)));
    for (std::size_t c = 0; c < line.count; ++c) {
      StoreFirst(d, hn::Mul(share, found[c]), coefficients.data + c * coefficients.stride + i,
                 live);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(Coefficients);

void runCoefficientKernel(const RefinedProblem<float>& problem, const CoefficientProblem& line,
                          PixelRows<const float> channels, PixelRows<const float> coordinates,
                          PixelRows<float> coefficients) {
  HWY_DYNAMIC_DISPATCH(Coefficients)(problem, line, channels, coordinates, coefficients);
}

}  // namespace cutis
#endif  // HWY_ONCE
