#include "core/fit/posterior_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fit/posterior_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/fit/linearise-inl.h"
#include "core/skin/partial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void Posterior(const RefinedProblem<float>& problem, const PosteriorBatch& batch) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t i = 0; i < batch.count; i += lanes) {
    const std::size_t live = batch.count - i < lanes ? batch.count - i : lanes;
    const auto inside = hn::FirstN(d, live);
    V channels[kMaximumFitChannels];
    V precision[kMaximumFitChannels];
    for (std::size_t k = 0; k < problem.channelCount; ++k) {
      channels[k] = LoadFirst(d, batch.channels + k * batch.stride + i, live);
      precision[k] = ChannelPrecision(d, problem, channels[k]);
    }
    V point[kParameterCount];
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      point[k] = LoadFirst(d, batch.coordinates + k * batch.stride + i, live);
    }
    V modelled[kMaximumFitChannels][kLinearColumns];
    ModelWithDerivatives(d, problem, PointOf(d, problem, point), modelled);
    NormalEquations<V> normal;
    BuildNormalEquations(d, problem, channels, precision, point, modelled, normal);
    for (int k = 0; k < kParameterCount; ++k) {
      if (problem.isFixed[k]) normal.Hold(d, k, inside);
    }
    Factorisation<V> factor;
    normal.Factorise(d, factor);
    for (int k = 0; k < kParameterCount; ++k) {
      V unit[kParameterCount];
      for (int j = 0; j < kParameterCount; ++j) unit[j] = hn::Set(d, j == k ? 1.0f : 0.0f);
      V column[kParameterCount];
      factor.Solve(d, unit, column);
      const V deviation = problem.isFixed[k] ? hn::Zero(d) : hn::Sqrt(column[k]);
      StoreFirst(d, deviation, batch.deviations + static_cast<std::size_t>(k) * batch.stride + i,
                 live);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(Posterior);

void runPosteriorKernel(const RefinedProblem<float>& problem, const PosteriorBatch& batch) {
  HWY_DYNAMIC_DISPATCH(Posterior)(problem, batch);
}

}  // namespace cutis
#endif  // HWY_ONCE
