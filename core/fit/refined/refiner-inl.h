// Gauss–Newton for one vector of pixels. Included once per instruction set (Highway).

#if defined(CUTIS_CORE_FIT_REFINED_REFINER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_FIT_REFINED_REFINER_INL_H_
#undef CUTIS_CORE_FIT_REFINED_REFINER_INL_H_
#else
#define CUTIS_CORE_FIT_REFINED_REFINER_INL_H_
#endif

#include <hwy/highway.h>

#include "core/fit/refined/coefficients-inl.h"
#include "core/fit/refined/lane_state-inl.h"
#include "core/fit/refined/linearise-inl.h"
#include "core/fit/refined/refined_kernel.h"
#include "core/fit/refined/start_polynomial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
class Refiner {
  using T = hn::TFromD<D>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

 public:
  Refiner(const RefinedProblem<T>& problem, const RefinedPixels<T>& pixels)
      : problem_(problem), pixels_(pixels) {}

  // Pixels [first, first + live), live ≤ lanes, from the start.
  HWY_INLINE void Begin(std::size_t first, std::size_t live) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      pixel_[lane] = static_cast<std::uint32_t>(first + (lane < live ? lane : 0));
      rounds_[lane] = 0;
    }
    const D d;
    LoadChannels();
    if (problem_.start != nullptr) {
      StartPoint(d, *problem_.start, problem_.channelCount, lanes_.measured, lanes_.base);
    } else {
      for (int i = 0; i < kParameterCount; ++i) {
        lanes_.base[i] = Gather(pixels_.coordinates.data +
                                static_cast<std::size_t>(i) * pixels_.coordinates.stride);
      }
    }
    for (int i = 0; i < kParameterCount; ++i) {
      lanes_.base[i] =
          problem_.isFixed[i] ? hn::Set(d, problem_.priorMean[i]) : Boxed(i, lanes_.base[i]);
      lanes_.step[i] = hn::Zero(d);
    }
    lanes_.share = hn::Set(d, T(1));
    lanes_.cost = hn::Set(d, Infinity());
    lanes_.decrease = hn::Zero(d);
    lanes_.doubtful = hn::Zero(d);
    live_ = live;
  }

  // Lanes put aside earlier.
  HWY_INLINE void Resume(const Straggler<T>* stragglers, std::size_t live) {
    const D d;
    HWY_ALIGN T fields[Straggler<T>::kFields][kLanes];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const Straggler<T>& straggler = stragglers[lane < live ? lane : 0];
      pixel_[lane] = straggler.pixel;
      rounds_[lane] = straggler.rounds;
      for (int k = 0; k < Straggler<T>::kFields; ++k)
        fields[k][lane] = straggler.fields[k];
    }
    LoadChannels();
    LoadFields(d, fields, lanes_);
    live_ = live;
  }

  // Rounds until all lanes are done, or until at most `patience` of them are not: those are
  // appended to `aside`. Returns how many.
  HWY_INLINE std::size_t Run(std::size_t patience, Straggler<T>* aside) {
    const D d;
    const M all = hn::FirstN(d, live_);
    M active = all;
    do {
      active = FullRound(active);
      if (hn::AllFalse(d, active)) break;
      active = ChordRound(active);
    } while (hn::CountTrue(d, active) > patience);
    const M finished = hn::AndNot(active, all);
    if (WantsCoefficients() && !hn::AllFalse(d, finished)) WriteCoefficients(finished);
    return hn::AllFalse(d, active) ? 0 : PutAside(active, aside);
  }

  static constexpr std::size_t kLanes = hn::MaxLanes(D());

 private:
  // No reflectance is near it, and its square is far from what a float can hold.
  static constexpr T kBlinding = T(1e4);

  static constexpr T Infinity() { return static_cast<T>(3.0e38); }

  HWY_INLINE bool WantsCoefficients() const {
    return problem_.hasDiscrepancy && pixels_.coefficients.data != nullptr;
  }

  HWY_INLINE V Gather(const T* row) const {
    HWY_ALIGN T values[kLanes];
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      values[lane] = row[pixel_[lane]];
    return hn::Load(D(), values);
  }

  HWY_INLINE V Boxed(int i, V value) const {
    const D d;
    return hn::Min(hn::Max(value, hn::Set(d, problem_.low[i])), hn::Set(d, problem_.high[i]));
  }

  HWY_INLINE void LoadChannels() {
    const D d;
    HWY_ALIGN T values[kLanes];
    for (std::size_t k = 0; k < problem_.channelCount; ++k) {
      const float* row = pixels_.channels.data + k * pixels_.channels.stride;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const T value = static_cast<T>(row[pixel_[lane]]);
        values[lane] = value < kBlinding ? value : kBlinding;
      }
      lanes_.measured[k] = hn::Load(d, values);
    }
    if (problem_.hasDiscrepancy) {
      WhitenMeasured(d, problem_, lanes_.measured, lanes_.precision, lanes_.channels,
                     lanes_.whitening);
      return;
    }
    for (std::size_t k = 0; k < problem_.channelCount; ++k) {
      lanes_.channels[k] = lanes_.measured[k];
      lanes_.precision[k] = ChannelPrecision(d, problem_, lanes_.measured[k]);
    }
  }

  // Coordinates that stay: fixed ones, and those at a bound whose way down leads out of the box.
  HWY_INLINE void Hold(const V* trial, NormalEquations<V>& normal) {
    const D d;
    const V zero = hn::Zero(d);
    for (int i = 0; i < kParameterCount; ++i) {
      const V down = normal.downhill[i];
      const M below = hn::And(hn::Le(trial[i], hn::Set(d, problem_.low[i])), hn::Le(down, zero));
      const M above = hn::And(hn::Ge(trial[i], hn::Set(d, problem_.high[i])), hn::Ge(down, zero));
      M held = hn::Or(below, above);
      if (problem_.isFixed[i]) held = hn::Eq(zero, zero);
      lanes_.free[i] = hn::IfThenZeroElse(held, hn::Set(d, T(1)));
      if (!hn::AllFalse(d, held)) normal.Hold(d, i, held);
    }
  }

  // A step follows the model's curvature where it is known: dermal blood and melanin act by the
  // root of their absorption, and what the data determine is the amount of each melanin, C_m β_m,
  // rather than the blend.
  HWY_INLINE void PointAlong(const V* base, const V* step, V share, V* point) const {
    const D d;
    for (int i = 0; i < kParameterCount; ++i) {
      if (problem_.isFixed[i]) {
        point[i] = base[i];
        continue;
      }
      V move = hn::Mul(share, step[i]);
      if (problem_.rootOffset[i] > T(0) && !problem_.isLog[i]) {
        // √(C + c) moves in proportion: C changes by δ + δ² / 4 (C + c).
        const V root = hn::Add(base[i], hn::Set(d, problem_.rootOffset[i]));
        const V bend = hn::Div(move, hn::Mul(hn::Set(d, T(4)), root));
        move = hn::MulAdd(move, hn::Min(bend, hn::Set(d, T(1))), move);
      }
      point[i] = Boxed(i, hn::Add(base[i], move));
    }
    if (problem_.isLog[kMelanin] || problem_.isFixed[kMelaninBlend]) return;
    const V ratio = hn::Div(base[kMelanin], hn::Max(point[kMelanin], hn::Set(d, T(1e-6))));
    const V move = hn::Mul(hn::Mul(share, step[kMelaninBlend]), ratio);
    point[kMelaninBlend] = Boxed(kMelaninBlend, hn::Add(base[kMelaninBlend], move));
  }

  // A round with derivatives. Returns the lanes that are still active.
  HWY_INLINE M FullRound(M active) {
    const D d;
    V trial[kParameterCount];
    PointAlong(lanes_.base, lanes_.step, lanes_.share, trial);
    ModelWithDerivatives(d, problem_, PointOf(d, problem_, trial), lanes_.modelled);
    ExpectDiscrepancy(d, problem_, lanes_, trial, lanes_.modelled);
    NormalEquations<V> normal;
    BuildNormalEquations(d, problem_, lanes_.channels, lanes_.precision, trial, lanes_.modelled,
                         normal);
    Hold(trial, normal);
    V downhill[kParameterCount];
    for (int i = 0; i < kParameterCount; ++i)
      downhill[i] = normal.downhill[i];
    V step[kParameterCount];
    lanes_.unsure = hn::Zero(d);
    StepWithinBox(trial, normal, step);
    return Settle<false>(active, trial, downhill, normal.cost, step);
  }

  // The lowest point of the quadratic model within the box, by fixing each coordinate that would
  // leave it to its bound and solving again for the others. Clipping the step instead would stall:
  // the others would move as if the clipped ones had, too.
  HWY_INLINE void StepWithinBox(const V* trial, NormalEquations<V>& normal, V* step) {
    const D d;
    for (int attempt = 0;; ++attempt) {
      normal.Factorise(d, lanes_.factor);
      lanes_.factor.Solve(d, normal.downhill, step);
      if (attempt == kParameterCount - 1) return;
      M crossing[kParameterCount];
      M any = hn::FirstN(d, 0);
      V bound[kParameterCount];
      for (int i = 0; i < kParameterCount; ++i) {
        const V target = hn::Add(trial[i], step[i]);
        bound[i] = Boxed(i, target);
        crossing[i] = hn::And(hn::Ne(bound[i], target), hn::Gt(lanes_.free[i], hn::Zero(d)));
        if (problem_.isFixed[i]) crossing[i] = hn::FirstN(d, 0);
        any = hn::Or(any, crossing[i]);
      }
      if (hn::AllFalse(d, any)) return;
      for (int i = 0; i < kParameterCount; ++i) {
        normal.Prescribe(d, i, crossing[i], hn::Sub(bound[i], trial[i]));
        lanes_.free[i] = hn::IfThenZeroElse(crossing[i], lanes_.free[i]);
      }
      // A coordinate at its bound may want back into the box: only new derivatives show whether.
      lanes_.unsure = hn::IfThenElse(any, hn::Set(d, T(1)), lanes_.unsure);
    }
  }

  // A coordinate that was held at its bound may want back by now.
  HWY_INLINE void DoubtHeld(const V* trial, const V* downhill) {
    const D d;
    const V zero = hn::Zero(d);
    for (int i = 0; i < kParameterCount; ++i) {
      if (problem_.isFixed[i]) continue;
      const M up =
          hn::And(hn::Le(trial[i], hn::Set(d, problem_.low[i])), hn::Gt(downhill[i], zero));
      const M back =
          hn::And(hn::Ge(trial[i], hn::Set(d, problem_.high[i])), hn::Lt(downhill[i], zero));
      const M inward = hn::And(hn::Or(up, back), hn::Eq(lanes_.free[i], zero));
      lanes_.unsure = hn::IfThenElse(inward, hn::Set(d, T(1)), lanes_.unsure);
    }
  }

  // A round with the derivatives and the factorisation of the round before.
  HWY_INLINE M ChordRound(M active) {
    const D d;
    V trial[kParameterCount];
    PointAlong(lanes_.base, lanes_.step, lanes_.share, trial);
    V modelled[kMaximumFitChannels][1];
    ModelOnly(d, problem_, PointOf(d, problem_, trial), modelled);
    ExpectDiscrepancy(d, problem_, lanes_, trial, modelled);
    V cost = hn::Zero(d);
    V shading = hn::Set(d, T(1));
    if (problem_.shadingPrecision > T(0)) {
      shading = ShadingOf(d, problem_, lanes_.channels, lanes_.precision, modelled).factor;
      cost = ShadingCost(d, problem_, shading);
    }
    V downhill[kParameterCount];
    for (V& component : downhill)
      component = hn::Zero(d);
    for (std::size_t k = 0; k < problem_.channelCount; ++k) {
      const V residual = hn::NegMulAdd(shading, modelled[k][0], lanes_.channels[k]);
      const V weighted = hn::Mul(residual, lanes_.precision[k]);
      cost = hn::MulAdd(weighted, residual, cost);
      for (int i = 0; i < kParameterCount; ++i) {
        downhill[i] = hn::MulAdd(weighted, lanes_.modelled[k][1 + i], downhill[i]);
      }
    }
    if (problem_.shadingPrecision > T(0)) {
      for (V& component : downhill)
        component = hn::Mul(shading, component);
    }
    AddPrior(d, problem_, trial, downhill, cost);
    DoubtHeld(trial, downhill);
    for (std::size_t k = 0; k < problem_.channelCount; ++k)
      lanes_.modelled[k][0] = modelled[k][0];
    for (int i = 0; i < kParameterCount; ++i)
      downhill[i] = hn::Mul(downhill[i], lanes_.free[i]);
    V step[kParameterCount];
    lanes_.factor.Solve(d, downhill, step);
    return Settle<true>(active, trial, downhill, cost, step);
  }

  // Accepts the trial point, from which `step` leads on, or looks for a better one; writes the
  // lanes that are finished. Returns the others.
  template <bool kChord>
  HWY_INLINE M Settle(M active, const V* trial, const V* downhill, V cost, const V* step) {
    const D d;
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, T(1));
    // Back at the base, for derivatives there; the chord has none.
    const M atBase = hn::And(active, hn::Eq(lanes_.share, zero));
    const M better = hn::And(active, hn::Le(cost, lanes_.cost));
    const M accepted = kChord ? hn::AndNot(atBase, better) : hn::Or(better, atBase);
    const M rejected = hn::AndNot(hn::Or(accepted, atBase), active);
    const V before = lanes_.decrease;

    V decrease = zero;
    for (int i = 0; i < kParameterCount; ++i) {
      decrease = hn::MulAdd(step[i], downhill[i], decrease);
    }
    const V shorter = ShorterShare(d, lanes_, cost);
    lanes_.share = hn::IfThenElse(accepted, one, hn::IfThenElse(rejected, shorter, lanes_.share));
    lanes_.cost = hn::IfThenElse(accepted, cost, lanes_.cost);
    lanes_.decrease = hn::IfThenElse(accepted, decrease, lanes_.decrease);
    for (int i = 0; i < kParameterCount; ++i) {
      lanes_.base[i] = hn::IfThenElse(accepted, trial[i], lanes_.base[i]);
      lanes_.step[i] = hn::IfThenElse(accepted, step[i], lanes_.step[i]);
    }

    M stuck = hn::FirstN(d, 0);
    if constexpr (kChord) {
      lanes_.doubtful = hn::IfThenElse(accepted, one, lanes_.doubtful);
    } else {
      // A step that need not lead down is dropped for Newton's from the base; Newton's is
      // shortened.
      const M dropped = hn::And(rejected, hn::Gt(lanes_.doubtful, zero));
      lanes_.share = hn::IfThenZeroElse(dropped, lanes_.share);
      lanes_.doubtful = hn::IfThenZeroElse(hn::Or(accepted, dropped), lanes_.doubtful);
      lanes_.unsure = hn::IfThenElse(rejected, one, lanes_.unsure);
      // Newton's step leads down unless rounding says otherwise.
      stuck = hn::And(hn::AndNot(dropped, rejected), hn::Lt(lanes_.share, hn::Set(d, T(1e-3))));
    }

    V limit = Tolerance();
    // A chord step is small across a valley even where the way along it is long, and promises less
    // than there is; only one that is far smaller than the step before shows that the end is near.
    if constexpr (kChord) {
      limit = hn::Min(hn::Mul(limit, hn::Set(d, T(0.3))), hn::Mul(before, hn::Set(d, T(0.02))));
    }
    M small = hn::And(accepted, hn::Lt(decrease, limit));
    if constexpr (kChord) small = hn::And(small, hn::Eq(lanes_.unsure, zero));
    const M converged = hn::Or(small, hn::And(stuck, WithinRounding()));
    const M finished = hn::Or(hn::Or(converged, stuck), hn::And(active, Tired()));
    Write(finished, converged, accepted, trial);
    return hn::AndNot(finished, active);
  }

  // Where no skin meets the channels, the noise says nothing of how well the parameters are known;
  // the misfit does.
  HWY_INLINE V Tolerance() const {
    const D d;
    const T expected = T(4) * static_cast<T>(problem_.channelCount);
    const V misfit = hn::Max(hn::Mul(lanes_.cost, hn::Set(d, T(1) / expected)), hn::Set(d, T(1)));
    return hn::Mul(misfit, hn::Set(d, problem_.tolerance));
  }

  // Whether what a shortened step promises is lost in the rounding of the cost.
  HWY_INLINE M WithinRounding() const {
    const D d;
    const V rounding = hn::Set(d, sizeof(T) == 4 ? T(1e-5) : T(1e-13));
    const V promised = hn::Mul(lanes_.decrease, hn::Set(d, T(2e-3)));
    return hn::Lt(promised, hn::MulAdd(lanes_.cost, rounding, Tolerance()));
  }

  // Counts the round; lanes that have had as many as they may.
  HWY_INLINE M Tired() {
    const D d;
    HWY_ALIGN T tired[kLanes];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      tired[lane] =
          ++rounds_[lane] >= static_cast<std::uint32_t>(problem_.maximumRounds) ? T(1) : T(0);
    }
    return hn::Gt(hn::Load(d, tired), hn::Zero(d));
  }

  // In single precision finished lanes take their last step unseen: it is shorter than what the
  // tolerance lets matter. In double precision, where hardly any noise is assumed, a step that
  // promises little may be a long way along a valley, and its end anywhere.
  HWY_INLINE void Write(M finished, M converged, M accepted, const V* trial) {
    const D d;
    if (hn::AllFalse(d, finished)) return;
    HWY_ALIGN T values[kParameterCount][kLanes];
    HWY_ALIGN T flags[2][kLanes];
    HWY_ALIGN T costs[kLanes];
    const V nothing = hn::Zero(d);
    const V share = sizeof(T) == 4 ? hn::IfThenElse(converged, lanes_.share, nothing) : nothing;
    V last[kParameterCount];
    PointAlong(lanes_.base, lanes_.step, share, last);
    for (int i = 0; i < kParameterCount; ++i)
      hn::Store(last[i], d, values[i]);
    const V one = hn::Set(d, T(1));
    hn::Store(hn::IfThenElseZero(finished, one), d, flags[0]);
    hn::Store(hn::IfThenElseZero(converged, one), d, flags[1]);
    hn::Store(lanes_.cost, d, costs);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (flags[0][lane] == T(0)) continue;
      const std::size_t pixel = pixel_[lane];
      for (std::size_t i = 0; i < kParameterCount; ++i) {
        pixels_.coordinates.data[i * pixels_.coordinates.stride + pixel] = values[i][lane];
      }
      pixels_.converged[pixel] = flags[1][lane] != T(0);
      if (pixels_.costs != nullptr) pixels_.costs[pixel] = costs[lane];
      pixels_.rounds[pixel] = static_cast<std::uint16_t>(pixels_.rounds[pixel] + rounds_[lane]);
    }
    if (!WantsCoefficients()) return;
    NoteEnds(d, problem_, lanes_, trial, last, finished, hn::AndNot(accepted, finished), ends_);
  }

  // Writes the coefficients of the lanes that finished in a run.
  HWY_INLINE void WriteCoefficients(M finished) {
    const D d;
    V found[kMaximumCoefficients];
    CoefficientsAt(d, problem_, lanes_, ends_, found);
    HWY_ALIGN T flags[kLanes];
    HWY_ALIGN T values[kMaximumCoefficients][kLanes];
    hn::Store(hn::IfThenElseZero(finished, hn::Set(d, T(1))), d, flags);
    for (std::size_t c = 0; c < problem_.coefficientCount; ++c)
      hn::Store(found[c], d, values[c]);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (flags[lane] == T(0)) continue;
      float* column = pixels_.coefficients.data + pixel_[lane];
      for (std::size_t c = 0; c < problem_.coefficientCount; ++c)
        column[c * pixels_.coefficients.stride] = static_cast<float>(values[c][lane]);
    }
  }

  HWY_INLINE std::size_t PutAside(M active, Straggler<T>* aside) {
    const D d;
    HWY_ALIGN T flags[kLanes];
    HWY_ALIGN T fields[Straggler<T>::kFields][kLanes];
    hn::Store(hn::IfThenElseZero(active, hn::Set(d, T(1))), d, flags);
    StoreFields(d, lanes_, fields);
    std::size_t count = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (flags[lane] == T(0)) continue;
      Straggler<T>& straggler = aside[count++];
      straggler.pixel = pixel_[lane];
      straggler.rounds = rounds_[lane];
      for (int k = 0; k < Straggler<T>::kFields; ++k)
        straggler.fields[k] = fields[k][lane];
    }
    return count;
  }

  const RefinedProblem<T>& problem_;
  const RefinedPixels<T>& pixels_;
  Lanes<V> lanes_;
  Ends<V> ends_;
  std::uint32_t pixel_[kLanes];
  std::uint32_t rounds_[kLanes];
  std::size_t live_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
