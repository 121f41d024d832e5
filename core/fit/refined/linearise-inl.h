// The model of a vector of pixels, its derivatives and its normal equations. Included once per
// instruction set (Highway).

#if defined(CUTIS_CORE_FIT_REFINED_LINEARISE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_FIT_REFINED_LINEARISE_INL_H_
#undef CUTIS_CORE_FIT_REFINED_LINEARISE_INL_H_
#else
#define CUTIS_CORE_FIT_REFINED_LINEARISE_INL_H_
#endif

#include <hwy/highway.h>

#include "core/fit/refined/normal_equations-inl.h"
#include "core/fit/refined/refined_kernel.h"
#include "core/skin/layers/node_reflectance-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The variance of a measured channel by its noise, and 1 / variance.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V ChannelVariance(D d, const RefinedProblem<hn::TFromD<D>>& problem, V channel) {
  const V varying = hn::Add(channel, hn::Set(d, problem.veil));
  return hn::MulAdd(hn::Mul(hn::Set(d, problem.proportionalVariance), varying), varying,
                    hn::Set(d, problem.readVariance));
}
template <class D, class V = hn::Vec<D>>
HWY_INLINE V ChannelPrecision(D d, const RefinedProblem<hn::TFromD<D>>& problem, V channel) {
  return hn::Div(hn::Set(d, hn::TFromD<D>(1)), ChannelVariance(d, problem, channel));
}

// Parameters at a point of coordinates.
template <class V>
struct PointVectors {
  V value[kParameterCount];
  AmountVectors<V> amounts;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE PointVectors<V> PointOf(D d, const RefinedProblem<hn::TFromD<D>>& problem,
                                   const V* coordinates) {
  PointVectors<V> point;
  for (int i = 0; i < kParameterCount; ++i) {
    point.value[i] = problem.isLog[i] ? ExpOfNegative(d, coordinates[i]) : coordinates[i];
  }
  point.amounts = AmountsOf([&](int i) HWY_ATTR { return point.value[i]; });
  return point;
}

// Sums kRows channels from kColumns quantities per node at once: the sums stay in registers.
template <std::size_t kRows, std::size_t kColumns, class D, class V = hn::Vec<D>>
HWY_INLINE void SumNodes(D d, const V (*quantities)[kColumns], std::size_t nodeCount,
                         const hn::TFromD<D>* weights, V (*sums)[kColumns]) {
  V sum[kRows][kColumns];
  for (std::size_t k = 0; k < kRows; ++k) {
    for (std::size_t c = 0; c < kColumns; ++c)
      sum[k][c] = hn::Zero(d);
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
    for (std::size_t c = 0; c < kColumns; ++c)
      sums[k][c] = sum[k][c];
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
  static_assert(kParameterCount == 5, "a sixth has its derivative below");
  const V perBlend = hn::Mul(point.value[kMelanin], perCoordinate[kMelaninBlend]);
  V nodes[kMaximumFitNodes][kLinearColumns];
  for (std::size_t n = 0; n < problem.nodeCount; ++n) {
    const NodeConstants<T>& node = problem.nodes[n];
    V epidermal, dermal;
    NodeAbsorption(d, node, point.amounts, epidermal, dermal);
    const LayeredVectors<V> layered =
        NodeReflectanceOf<true>(d, problem.layers, node, epidermal, dermal);
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
    NodeAbsorption(d, problem.nodes[n], point.amounts, epidermal, dermal);
    nodes[n][0] = NodeReflectanceOf<false>(d, problem.layers, problem.nodes[n], epidermal, dermal)
                      .reflectance;
  }
  SumAllNodes<4, 1>(d, problem, nodes, channels);
}

// Cost and downhill direction at a point, from the residuals and the derivatives of the channels;
// the derivatives may be those of a point nearby.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void AddPrior(D d, const RefinedProblem<hn::TFromD<D>>& problem, const V* coordinates,
                         V* downhill, V& cost) {
  V towardsMean[kParameterCount];
  for (int i = 0; i < kParameterCount; ++i) {
    towardsMean[i] = hn::Sub(hn::Set(d, problem.priorMean[i]), coordinates[i]);
  }
  for (int i = 0; i < kParameterCount; ++i) {
    if (problem.isFixed[i]) continue;
    V pull = hn::Mul(towardsMean[i], hn::Set(d, problem.priorPrecision[i][i]));
    for (int j = 0; j < kParameterCount; ++j) {
      // Most priors know of no correlation.
      if (j == i || problem.priorPrecision[i][j] == 0) continue;
      pull = hn::MulAdd(towardsMean[j], hn::Set(d, problem.priorPrecision[i][j]), pull);
    }
    downhill[i] = hn::Add(downhill[i], pull);
    cost = hn::MulAdd(pull, towardsMean[i], cost);
  }
}

// The factor on all channels that suits the modelled ones best, see core/fit/shading.h, and the
// cost's curvature along it.
template <class V>
struct ShadingVectors {
  V factor;
  V curvature;
};

template <std::size_t kColumns, class D, class V = hn::Vec<D>>
HWY_INLINE ShadingVectors<V> ShadingOf(D d, const RefinedProblem<hn::TFromD<D>>& problem,
                                       const V* measured, const V* precision,
                                       const V (*channels)[kColumns]) {
  const V prior = hn::Set(d, problem.shadingPrecision);
  V above = prior, below = prior;
  for (std::size_t k = 0; k < problem.channelCount; ++k) {
    const V weighted = hn::Mul(precision[k], channels[k][0]);
    above = hn::MulAdd(weighted, measured[k], above);
    below = hn::MulAdd(weighted, channels[k][0], below);
  }
  return {hn::Div(above, below), below};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V ShadingCost(D d, const RefinedProblem<hn::TFromD<D>>& problem, V factor) {
  const V away = hn::Sub(factor, hn::Set(d, hn::TFromD<D>(1)));
  return hn::Mul(hn::Mul(away, away), hn::Set(d, problem.shadingPrecision));
}

// The channels' part of the normal equations, with a factor that follows the parameters: what it
// can make up for is no information about them.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void AddShadedChannels(D d, const RefinedProblem<hn::TFromD<D>>& problem,
                                  const V* measured, const V* precision,
                                  const V (*channels)[kLinearColumns], NormalEquations<V>& normal) {
  const ShadingVectors<V> shading = ShadingOf(d, problem, measured, precision, channels);
  V cross[kParameterCount];
  for (V& value : cross)
    value = hn::Zero(d);
  for (std::size_t k = 0; k < problem.channelCount; ++k) {
    V row[kParameterCount];
    const V weighted = hn::Mul(precision[k], channels[k][0]);
    for (int i = 0; i < kParameterCount; ++i) {
      row[i] = hn::Mul(shading.factor, channels[k][1 + i]);
      cross[i] = hn::MulAdd(weighted, row[i], cross[i]);
    }
    normal.Add(d, row, hn::NegMulAdd(shading.factor, channels[k][0], measured[k]), precision[k]);
  }
  for (int i = 0; i < kParameterCount; ++i) {
    const V share = hn::Div(cross[i], shading.curvature);
    for (int j = 0; j <= i; ++j) {
      normal.hessian[i][j] = hn::NegMulAdd(share, cross[j], normal.hessian[i][j]);
    }
  }
  normal.cost = hn::Add(normal.cost, ShadingCost(d, problem, shading.factor));
}

// channels: from ModelWithDerivatives().
template <class D, class V = hn::Vec<D>>
HWY_INLINE void BuildNormalEquations(D d, const RefinedProblem<hn::TFromD<D>>& problem,
                                     const V* measured, const V* precision, const V* coordinates,
                                     const V (*channels)[kLinearColumns],
                                     NormalEquations<V>& normal) {
  normal.Clear(d);
  if (problem.shadingPrecision > 0) {
    AddShadedChannels(d, problem, measured, precision, channels, normal);
  } else {
    for (std::size_t k = 0; k < problem.channelCount; ++k) {
      normal.Add(d, channels[k] + 1, hn::Sub(measured[k], channels[k][0]), precision[k]);
    }
  }
  AddPrior(d, problem, coordinates, normal.downhill, normal.cost);
  for (int i = 0; i < kParameterCount; ++i) {
    if (problem.isFixed[i]) continue;
    for (int j = 0; j <= i; ++j) {
      normal.hessian[i][j] =
          hn::Add(normal.hessian[i][j], hn::Set(d, problem.priorPrecision[i][j]));
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
