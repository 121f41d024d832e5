// The normal equations of a vector of pixels at a point. Included once per instruction set (Highway).

#if defined(CUTIS_CORE_FIT_LINEARISE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_FIT_LINEARISE_INL_H_
#undef CUTIS_CORE_FIT_LINEARISE_INL_H_
#else
#define CUTIS_CORE_FIT_LINEARISE_INL_H_
#endif

#include <hwy/highway.h>

#include "core/fit/normal_equations-inl.h"
#include "core/fit/refined_kernel.h"
#include "core/skin/diffusion-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// 1 / variance of a measured channel.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V ChannelPrecision(D d, const RefinedProblem<hn::TFromD<D>>& problem, V channel) {
  const V variance =
      hn::MulAdd(hn::Mul(hn::Set(d, problem.proportionalVariance), channel), channel,
                 hn::Set(d, problem.readVariance));
  return hn::Div(hn::Set(d, hn::TFromD<D>(1)), variance);
}

// point: coordinates. The parameters there and their derivatives with respect to the coordinates
// enter here.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void Linearise(D d, const RefinedProblem<hn::TFromD<D>>& problem, const V* channels,
                          const V* precision, const V* point, NormalEquations<V>& normal) {
  using T = hn::TFromD<D>;
  V value[kParameterCount];
  V perCoordinate[kParameterCount];
  for (int i = 0; i < kParameterCount; ++i) {
    value[i] = problem.isLog[i] ? ExpOfNegative(d, point[i]) : point[i];
    perCoordinate[i] = problem.isLog[i] ? value[i] : hn::Set(d, T(1));
  }
  V reflectance[kMaximumFitNodes];
  V epidermalSlope[kMaximumFitNodes];
  V dermalSlope[kMaximumFitNodes];
  const V melaninEu = hn::Mul(value[kMelanin], value[kMelaninBlend]);
  for (std::size_t n = 0; n < problem.nodeCount; ++n) {
    V epidermal, dermal;
    NodeAbsorption(d, problem.nodes[n], value[kMelanin], melaninEu, value[kHaemoglobinDermal],
                   value[kHaemoglobinEpidermal], value[kCarotene], epidermal, dermal);
    const LayeredVectors<V> layered = LayeredReflectanceOf<true>(
        d, problem.layers, problem.nodes[n], epidermal, dermal);
    reflectance[n] = layered.reflectance;
    epidermalSlope[n] = layered.perEpidermalAbsorption;
    dermalSlope[n] = layered.perDermalAbsorption;
  }
  normal.Clear(d);
  const FitWeight<T>* weights = problem.weights;
  for (std::size_t k = 0; k < problem.channelCount; ++k) {
    V modelled = hn::Zero(d);
    V pheomelanin = hn::Zero(d);
    V contrast = hn::Zero(d);
    V blood = hn::Zero(d);
    V carotene = hn::Zero(d);
    V dermal = hn::Zero(d);
    for (std::size_t n = 0; n < problem.nodeCount; ++n, ++weights) {
      modelled = hn::MulAdd(reflectance[n], hn::Set(d, weights->value), modelled);
      const V slope = epidermalSlope[n];
      pheomelanin = hn::MulAdd(slope, hn::Set(d, weights->pheomelanin), pheomelanin);
      contrast = hn::MulAdd(slope, hn::Set(d, weights->melaninContrast), contrast);
      blood = hn::MulAdd(slope, hn::Set(d, weights->epidermalBlood), blood);
      carotene = hn::MulAdd(slope, hn::Set(d, weights->carotene), carotene);
      dermal = hn::MulAdd(dermalSlope[n], hn::Set(d, weights->dermalBlood), dermal);
    }
    V row[kParameterCount];
    row[kMelanin] = hn::Mul(hn::MulAdd(value[kMelaninBlend], contrast, pheomelanin),
                            perCoordinate[kMelanin]);
    row[kMelaninBlend] =
        hn::Mul(hn::Mul(value[kMelanin], contrast), perCoordinate[kMelaninBlend]);
    row[kHaemoglobinDermal] = hn::Mul(dermal, perCoordinate[kHaemoglobinDermal]);
    row[kHaemoglobinEpidermal] = hn::Mul(blood, perCoordinate[kHaemoglobinEpidermal]);
    row[kCarotene] = hn::Mul(carotene, perCoordinate[kCarotene]);
    normal.Add(d, row, hn::Sub(channels[k], modelled), precision[k]);
  }
  for (int i = 0; i < kParameterCount; ++i) {
    if (problem.isFixed[i]) continue;
    normal.AddPrior(d, i, hn::Sub(hn::Set(d, problem.priorMean[i]), point[i]),
                    hn::Set(d, problem.priorPrecision[i]));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
