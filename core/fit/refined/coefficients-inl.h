// The coefficients of the discrepancy at an estimate. Included once per instruction set (Highway).

#if defined(CUTIS_CORE_FIT_REFINED_COEFFICIENTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_FIT_REFINED_COEFFICIENTS_INL_H_
#undef CUTIS_CORE_FIT_REFINED_COEFFICIENTS_INL_H_
#else
#define CUTIS_CORE_FIT_REFINED_COEFFICIENTS_INL_H_
#endif

#include <hwy/highway.h>

#include "core/fit/refined/lane_state-inl.h"
#include "core/fit/refined/linearise-inl.h"
#include "core/fit/refined/refined_kernel.h"
#include "core/fit/refined/whitening-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Where lanes end, each in a round of its own, until all of a vector are done.
template <class V>
struct Ends {
  V coordinates[kParameterCount];
  V residuals[kMaximumFitChannels][1];  // of the whitened channels, L⁻¹ (y − modelled) of Σ = L Lᵀ
};

// The modelled channels at a point, as the residuals want them, of some lanes.
template <class D, class V = hn::Vec<D>, class M = hn::Mask<D>>
HWY_NOINLINE void ModelAgain(D d, const RefinedProblem<hn::TFromD<D>>& problem,
                             const Lanes<V>& lanes, M some, const V* point, V (*modelled)[1]) {
  V again[kMaximumFitChannels][1];
  ModelOnly(d, problem, PointOf(d, problem, point), again);
  ExpectDiscrepancy(d, problem, lanes, point, again);
  for (std::size_t k = 0; k < problem.channelCount; ++k)
    modelled[k][0] = hn::IfThenElse(some, again[k][0], modelled[k][0]);
}

// Notes where `finished` lanes end. trial: where their last round looked; astray: those for which
// that is far from the end. In the others the last step is so short that channels follow it in
// proportion.
template <class D, class V = hn::Vec<D>, class M = hn::Mask<D>, class T = hn::TFromD<D>>
HWY_INLINE void NoteEnds(D d, const RefinedProblem<T>& problem, const Lanes<V>& lanes,
                         const V* trial, const V* last, M finished, M astray, Ends<V>& ends) {
  V step[kParameterCount];
  for (int i = 0; i < kParameterCount; ++i) {
    step[i] = hn::Sub(last[i], trial[i]);
    ends.coordinates[i] = hn::IfThenElse(finished, last[i], ends.coordinates[i]);
  }
  V modelled[kMaximumFitChannels][1];
  for (std::size_t k = 0; k < problem.channelCount; ++k) {
    modelled[k][0] = lanes.modelled[k][0];
    for (int i = 0; i < kParameterCount; ++i)
      modelled[k][0] = hn::MulAdd(lanes.modelled[k][1 + i], step[i], modelled[k][0]);
  }
  if (!hn::AllFalse(d, astray)) ModelAgain(d, problem, lanes, astray, last, modelled);
  V shading = hn::Set(d, T(1));
  if (problem.shadingPrecision > T(0))
    shading = ShadingOf(d, problem, lanes.channels, lanes.precision, modelled).factor;
  for (std::size_t k = 0; k < problem.channelCount; ++k) {
    const V residual = hn::NegMulAdd(shading, modelled[k][0], lanes.channels[k]);
    ends.residuals[k][0] = hn::IfThenElse(finished, residual, ends.residuals[k][0]);
  }
}

// The most probable coefficients at the ends (ChannelDiscrepancy), but no further from 0 than
// kMostCoefficientNorm.
template <class D, class V = hn::Vec<D>, class T = hn::TFromD<D>>
HWY_INLINE void CoefficientsAt(D d, const RefinedProblem<T>& problem, const Lanes<V>& lanes,
                               Ends<V>& ends, V* found) {
  lanes.whitening.ApplyTransposed(d, problem, ends.residuals);
  V weighed[kMaximumFitChannels];
  for (std::size_t k = 0; k < problem.channelCount; ++k)
    weighed[k] = hn::Mul(ends.residuals[k][0], lanes.measured[k]);
  V square = hn::Zero(d);
  for (std::size_t c = 0; c < problem.coefficientCount; ++c) {
    V sum = hn::Set(d, problem.coefficientOffset[c]);
    for (std::size_t i = 0; i < kParameterCount; ++i)
      sum = hn::MulAdd(hn::Set(d, problem.coefficientSlope[c][i]), ends.coordinates[i], sum);
    for (std::size_t k = 0; k < problem.channelCount; ++k)
      sum = hn::MulAdd(hn::Set(d, problem.coefficientGain[c][k]), weighed[k], sum);
    found[c] = sum;
    square = hn::MulAdd(sum, sum, square);
  }
  const V most = hn::Set(d, static_cast<T>(kMostCoefficientNorm));
  const V share = hn::Min(hn::Set(d, T(1)), hn::Div(most, hn::Sqrt(square)));
  for (std::size_t c = 0; c < problem.coefficientCount; ++c)
    found[c] = hn::Mul(share, found[c]);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
