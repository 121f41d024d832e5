// The model of a vector of pixels, its derivatives and its normal equations. Included once per
// instruction set (Highway).

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

// Parameters at a point of coordinates.
template <class V>
struct PointVectors {
  V value[kParameterCount];
  V melaninEu;  // C_m · β_m
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE PointVectors<V> PointOf(D d, const RefinedProblem<hn::TFromD<D>>& problem,
                                   const V* coordinates) {
  PointVectors<V> point;
  for (int i = 0; i < kParameterCount; ++i) {
    point.value[i] = problem.isLog[i] ? ExpOfNegative(d, coordinates[i]) : coordinates[i];
  }
  point.melaninEu = hn::Mul(point.value[kMelanin], point.value[kMelaninBlend]);
  return point;
}

// Sums kRows channels from kColumns quantities per node at once: the sums stay in registers.
template <std::size_t kRows, std::size_t kColumns, class D, class V = hn::Vec<D>>
HWY_INLINE void SumNodes(D d, const V (*quantities)[kColumns], std::size_t nodeCount,
                         const hn::TFromD<D>* weights, V (*sums)[kColumns]) {
  V sum[kRows][kColumns];
  for (std::size_t k = 0; k < kRows; ++k) {
    for (std::size_t c = 0; c < kColumns; ++c) sum[k][c] = hn::Zero(d);
  }
  for (std::size_t n = 0; n < nodeCount; ++n) {
    for (std::size_t k = 0; k < kRows; ++k) {
      const V weight = hn::Set(d, weights[k * nodeCount + n]);
      for (std::size_t c = 0; c < kColumns; ++c) {
        sum[k][c] = hn::MulAdd(quantities[n][c], weight, sum[k][c]);
      }
    }
  }
  for (std::size_t k = 0; k < kRows; ++k) {
    for (std::size_t c = 0; c < kColumns; ++c) sums[k][c] = sum[k][c];
  }
}

template <std::size_t kRows, std::size_t kColumns, class D, class V = hn::Vec<D>>
HWY_INLINE void SumAllNodes(D d, const RefinedProblem<hn::TFromD<D>>& problem,
                            const V (*quantities)[kColumns], V (*sums)[kColumns]) {
  std::size_t k = 0;
  const auto weights = [&] { return problem.weights + k * problem.nodeCount; };
  for (; k + kRows <= problem.channelCount; k += kRows) {
    SumNodes<kRows>(d, quantities, problem.nodeCount, weights(), sums + k);
  }
  for (; k < problem.channelCount; ++k) {
    SumNodes<1>(d, quantities, problem.nodeCount, weights(), sums + k);
  }
}

// A channel as modelled, then its derivatives with respect to the coordinates.
inline constexpr std::size_t kLinearColumns = 1 + kParameterCount;

template <class D, class V = hn::Vec<D>>
HWY_INLINE void ModelWithDerivatives(D d, const RefinedProblem<hn::TFromD<D>>& problem,
                                     const PointVectors<V>& point, V (*channels)[kLinearColumns]) {
  using T = hn::TFromD<D>;
  const V one = hn::Set(d, T(1));
  V perCoordinate[kParameterCount];
  for (int i = 0; i < kParameterCount; ++i) {
    perCoordinate[i] = problem.isLog[i] ? point.value[i] : one;
  }
  const V perBlend = hn::Mul(point.value[kMelanin], perCoordinate[kMelaninBlend]);
  V nodes[kMaximumFitNodes][kLinearColumns];
  for (std::size_t n = 0; n < problem.nodeCount; ++n) {
    const NodeConstants<T>& node = problem.nodes[n];
    V epidermal, dermal;
    NodeAbsorption(d, node, point.value[kMelanin], point.melaninEu,
                   point.value[kHaemoglobinDermal], point.value[kHaemoglobinEpidermal],
                   point.value[kCarotene], epidermal, dermal);
    const LayeredVectors<V> layered =
        LayeredReflectanceOf<true>(d, problem.layers, node, epidermal, dermal);
    const V slope = layered.perEpidermalAbsorption;
    const V contrast = hn::Set(d, node.melaninContrast);
    const V melanin =
        hn::MulAdd(point.value[kMelaninBlend], contrast, hn::Set(d, node.pheomelanin));
    V* out = nodes[n];
    out[0] = layered.reflectance;
    out[1 + kMelanin] = hn::Mul(hn::Mul(slope, melanin), perCoordinate[kMelanin]);
    out[1 + kMelaninBlend] = hn::Mul(hn::Mul(slope, contrast), perBlend);
    out[1 + kHaemoglobinDermal] =
        hn::Mul(hn::Mul(layered.perDermalAbsorption, hn::Set(d, node.dermalBlood)),
                perCoordinate[kHaemoglobinDermal]);
    out[1 + kHaemoglobinEpidermal] = hn::Mul(hn::Mul(slope, hn::Set(d, node.epidermalBlood)),
                                             perCoordinate[kHaemoglobinEpidermal]);
    out[1 + kCarotene] =
        hn::Mul(hn::Mul(slope, hn::Set(d, node.carotene)), perCoordinate[kCarotene]);
  }
  SumAllNodes<2, kLinearColumns>(d, problem, nodes, channels);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void ModelOnly(D d, const RefinedProblem<hn::TFromD<D>>& problem,
                          const PointVectors<V>& point, V (*channels)[1]) {
  V nodes[kMaximumFitNodes][1];
  for (std::size_t n = 0; n < problem.nodeCount; ++n) {
    V epidermal, dermal;
    NodeAbsorption(d, problem.nodes[n], point.value[kMelanin], point.melaninEu,
                   point.value[kHaemoglobinDermal], point.value[kHaemoglobinEpidermal],
                   point.value[kCarotene], epidermal, dermal);
    nodes[n][0] =
        LayeredReflectanceOf<false>(d, problem.layers, problem.nodes[n], epidermal, dermal)
            .reflectance;
  }
  SumAllNodes<4, 1>(d, problem, nodes, channels);
}

// Cost and downhill direction at a point, from the residuals and the derivatives of the channels;
// the derivatives may be those of a point nearby.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void AddPrior(D d, const RefinedProblem<hn::TFromD<D>>& problem, const V* coordinates,
                         V* downhill, V& cost) {
  for (int i = 0; i < kParameterCount; ++i) {
    if (problem.isFixed[i]) continue;
    const V towardsMean = hn::Sub(hn::Set(d, problem.priorMean[i]), coordinates[i]);
    const V pull = hn::Mul(towardsMean, hn::Set(d, problem.priorPrecision[i]));
    downhill[i] = hn::Add(downhill[i], pull);
    cost = hn::MulAdd(pull, towardsMean, cost);
  }
}

// channels: from ModelWithDerivatives().
template <class D, class V = hn::Vec<D>>
HWY_INLINE void BuildNormalEquations(D d, const RefinedProblem<hn::TFromD<D>>& problem,
                                     const V* measured, const V* precision, const V* coordinates,
                                     const V (*channels)[kLinearColumns],
                                     NormalEquations<V>& normal) {
  normal.Clear(d);
  for (std::size_t k = 0; k < problem.channelCount; ++k) {
    normal.Add(d, channels[k] + 1, hn::Sub(measured[k], channels[k][0]), precision[k]);
  }
  AddPrior(d, problem, coordinates, normal.downhill, normal.cost);
  for (int i = 0; i < kParameterCount; ++i) {
    if (problem.isFixed[i]) continue;
    normal.hessian[i][i] = hn::Add(normal.hessian[i][i], hn::Set(d, problem.priorPrecision[i]));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
