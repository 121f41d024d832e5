// What a vector of pixels carries from round to round of the fit. Included once per instruction set
// (Highway).

#if defined(CUTIS_CORE_FIT_REFINED_LANE_STATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_FIT_REFINED_LANE_STATE_INL_H_
#undef CUTIS_CORE_FIT_REFINED_LANE_STATE_INL_H_
#else
#define CUTIS_CORE_FIT_REFINED_LANE_STATE_INL_H_
#endif

#include <hwy/highway.h>

#include "core/fit/refined/linearise-inl.h"
#include "core/fit/refined/normal_equations-inl.h"
#include "core/fit/refined/refined_kernel.h"
#include "core/fit/refined/whitening-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A vector of pixels between two rounds.
template <class V>
struct Lanes {
  V measured[kMaximumFitChannels];
  // With a discrepancy: channels as whitened, each of variance 1.
  V channels[kMaximumFitChannels];
  V precision[kMaximumFitChannels];
  Whitening<V> whitening;
  V base[kParameterCount];  // the best point so far
  V step[kParameterCount];  // from there
  V share;                  // of the step that is tried next
  V cost;                   // at the base
  V decrease;               // of the cost that the whole step promises
  V doubtful;               // 1 where the step is not Newton's from the base itself, else 0
  // What the last round with derivatives left; the first column is the last round's of either kind.
  V modelled[kMaximumFitChannels][kLinearColumns];
  Factorisation<V> factor;
  V free[kParameterCount];  // 0 where the coordinate was held, else 1
  V unsure;  // 1 where a chord step at these derivatives cannot show convergence, else 0
};

// Where to try next along a rejected step: the parabola through both costs and the slope at the
// base says so, within limits.
template <class D, class V = hn::Vec<D>, class T = hn::TFromD<D>>
HWY_INLINE V ShorterShare(D d, const Lanes<V>& lanes, V cost) {
  const V two = hn::Set(d, T(2));
  const V curvature =
      hn::Div(hn::MulAdd(hn::Mul(two, lanes.decrease), lanes.share, hn::Sub(cost, lanes.cost)),
              hn::Mul(lanes.share, lanes.share));
  const V lowest = hn::Div(lanes.decrease, curvature);
  return hn::Max(hn::Mul(lanes.share, hn::Set(d, T(0.1))),
                 hn::Min(hn::Mul(lanes.share, hn::Set(d, T(0.5))), lowest));
}

// Modelled channels, with or without derivatives, as the residuals want them.
template <std::size_t kColumns, class D, class V = hn::Vec<D>>
HWY_INLINE void ExpectDiscrepancy(D d, const RefinedProblem<hn::TFromD<D>>& problem,
                                  const Lanes<V>& lanes, const V* coordinates,
                                  V (*modelled)[kColumns]) {
  if (!problem.hasDiscrepancy) return;
  AddExpectedDiscrepancy(d, problem, lanes.measured, coordinates, modelled);
  lanes.whitening.Apply(d, problem, modelled);
}

// What goes to memory of a lane that is put aside.
template <typename T>
struct Straggler {
  static constexpr int kFields = 2 * kParameterCount + 4;

  std::uint32_t pixel;
  std::uint32_t rounds;
  T fields[kFields];  // base, step, share, cost, decrease, doubtful
};

template <class D, std::size_t kLanes, class V = hn::Vec<D>, class T = hn::TFromD<D>>
HWY_INLINE void StoreFields(D d, const Lanes<V>& lanes, T (*fields)[kLanes]) {
  for (int i = 0; i < kParameterCount; ++i) {
    hn::Store(lanes.base[i], d, fields[i]);
    hn::Store(lanes.step[i], d, fields[kParameterCount + i]);
  }
  T(*others)[kLanes] = fields + 2 * kParameterCount;
  hn::Store(lanes.share, d, others[0]);
  hn::Store(lanes.cost, d, others[1]);
  hn::Store(lanes.decrease, d, others[2]);
  hn::Store(lanes.doubtful, d, others[3]);
}

template <class D, std::size_t kLanes, class V = hn::Vec<D>, class T = hn::TFromD<D>>
HWY_INLINE void LoadFields(D d, const T (*fields)[kLanes], Lanes<V>& lanes) {
  for (int i = 0; i < kParameterCount; ++i) {
    lanes.base[i] = hn::Load(d, fields[i]);
    lanes.step[i] = hn::Load(d, fields[kParameterCount + i]);
  }
  const T(*others)[kLanes] = fields + 2 * kParameterCount;
  lanes.share = hn::Load(d, others[0]);
  lanes.cost = hn::Load(d, others[1]);
  lanes.decrease = hn::Load(d, others[2]);
  lanes.doubtful = hn::Load(d, others[3]);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
