#include "core/fit/refined_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fit/refined_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/fit/linearise-inl.h"
#include "core/fit/start_polynomial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A vector of pixels between two rounds.
template <class V>
struct Lanes {
  V channels[kMaximumFitChannels];
  V precision[kMaximumFitChannels];
  V base[kParameterCount];  // the best point so far
  V step[kParameterCount];  // from there
  V share;                  // of the step that is tried next
  V cost;                   // at the base
  V decrease;               // of the cost that the whole step promises
  // Of the last round with derivatives.
  V modelled[kMaximumFitChannels][kLinearColumns];
  Factorisation<V> factor;
  V free[kParameterCount];  // 0 where the coordinate was held, else 1
};

// What goes to memory of a lane that is put aside.
template <typename T>
struct Straggler {
  std::uint32_t pixel;
  std::uint32_t rounds;
  T base[kParameterCount];
  T step[kParameterCount];
  T share, cost, decrease;
};

template <class D>
class Refiner {
  using T = hn::TFromD<D>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

 public:
  Refiner(const RefinedProblem<T>& problem, const RefinedBatch<T>& batch)
      : problem_(problem), batch_(batch) {}

  // Pixels [first, first + live), live ≤ lanes, from the start.
  HWY_INLINE void Begin(std::size_t first, std::size_t live) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      pixel_[lane] = static_cast<std::uint32_t>(first + (lane < live ? lane : 0));
      rounds_[lane] = 0;
    }
    const D d;
    LoadChannels();
    if (problem_.start != nullptr) {
      StartPoint(d, *problem_.start, problem_.channelCount, lanes_.channels, lanes_.base);
    } else {
      for (int i = 0; i < kParameterCount; ++i) {
        lanes_.base[i] = Gather(batch_.coordinates + static_cast<std::size_t>(i) * batch_.stride);
      }
    }
    for (int i = 0; i < kParameterCount; ++i) {
      lanes_.base[i] = problem_.isFixed[i] ? hn::Set(d, problem_.priorMean[i])
                                           : Boxed(i, lanes_.base[i]);
      lanes_.step[i] = hn::Zero(d);
    }
    lanes_.share = hn::Set(d, T(1));
    lanes_.cost = hn::Set(d, Infinity());
    lanes_.decrease = hn::Zero(d);
    live_ = live;
  }

  // Lanes put aside earlier.
  HWY_INLINE void Resume(const Straggler<T>* stragglers, std::size_t live) {
    const D d;
    HWY_ALIGN T column[kLanes];
    const auto load = [&](auto field) HWY_ATTR {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        column[lane] = field(stragglers[lane < live ? lane : 0]);
      }
      return hn::Load(d, column);
    };
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const Straggler<T>& straggler = stragglers[lane < live ? lane : 0];
      pixel_[lane] = straggler.pixel;
      rounds_[lane] = straggler.rounds;
    }
    LoadChannels();
    for (int i = 0; i < kParameterCount; ++i) {
      lanes_.base[i] = load([i](const Straggler<T>& s) { return s.base[i]; });
      lanes_.step[i] = load([i](const Straggler<T>& s) { return s.step[i]; });
    }
    lanes_.share = load([](const Straggler<T>& s) { return s.share; });
    lanes_.cost = load([](const Straggler<T>& s) { return s.cost; });
    lanes_.decrease = load([](const Straggler<T>& s) { return s.decrease; });
    live_ = live;
  }

  // Rounds until all lanes are done, or until at most `patience` of them are not: those are appended
  // to `aside`. Returns how many.
  HWY_INLINE std::size_t Run(std::size_t patience, Straggler<T>* aside) {
    const D d;
    M active = hn::FirstN(d, live_);
    while (true) {
      active = FullRound(active);
      if (hn::AllFalse(d, active)) return 0;
      active = ChordRound(active);
      const std::size_t left = hn::CountTrue(d, active);
      if (left == 0) return 0;
      if (left <= patience) return PutAside(active, aside);
    }
  }

  static constexpr std::size_t kLanes = hn::MaxLanes(D());

 private:
  static constexpr T Infinity() { return static_cast<T>(3.0e38); }

  HWY_INLINE V Gather(const T* row) const {
    HWY_ALIGN T values[kLanes];
    for (std::size_t lane = 0; lane < kLanes; ++lane) values[lane] = row[pixel_[lane]];
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
      const float* row = batch_.channels + k * batch_.stride;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        values[lane] = static_cast<T>(row[pixel_[lane]]);
      }
      lanes_.channels[k] = hn::Load(d, values);
      lanes_.precision[k] = ChannelPrecision(d, problem_, lanes_.channels[k]);
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

  // A step follows the model's curvature where it is known: dermal blood and melanin act by the root
  // of their absorption, and what the data tell is the amount of each melanin, C_m β_m, rather than
  // the blend.
  HWY_INLINE void PointAlong(const V* base, const V* step, V share, V* point) const {
    const D d;
    for (int i = 0; i < kParameterCount; ++i) {
      if (problem_.isFixed[i]) {
        point[i] = base[i];
        continue;
      }
      V move = hn::Mul(share, step[i]);
      if (problem_.rootOffset[i] > T(0)) {
        // √(C + c) moves in proportion: C changes by δ + δ² / 4 (C + c).
        const V root = hn::Add(base[i], hn::Set(d, problem_.rootOffset[i]));
        const V bend = hn::Div(move, hn::Mul(hn::Set(d, T(4)), root));
        move = hn::MulAdd(move, hn::Min(bend, hn::Set(d, T(1))), move);
      }
      point[i] = Boxed(i, hn::Add(base[i], move));
    }
    if (problem_.isLog[kMelanin] || problem_.isFixed[kMelaninBlend]) return;
    const V ratio =
        hn::Div(base[kMelanin], hn::Max(point[kMelanin], hn::Set(d, T(1e-6))));
    const V move = hn::Mul(hn::Mul(share, step[kMelaninBlend]), ratio);
    point[kMelaninBlend] = Boxed(kMelaninBlend, hn::Add(base[kMelaninBlend], move));
  }

  // With derivatives. Returns the lanes that are still active.
  HWY_INLINE M FullRound(M active) {
    const D d;
    V trial[kParameterCount];
    PointAlong(lanes_.base, lanes_.step, lanes_.share, trial);
    ModelWithDerivatives(d, problem_, PointOf(d, problem_, trial), lanes_.modelled);
    NormalEquations<V> normal;
    BuildNormalEquations(d, problem_, lanes_.channels, lanes_.precision, trial, lanes_.modelled,
                         normal);
    Hold(trial, normal);
    V downhill[kParameterCount];
    for (int i = 0; i < kParameterCount; ++i) downhill[i] = normal.downhill[i];
    V step[kParameterCount];
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
    }
  }

  // With the derivatives and the factorisation of the round before.
  HWY_INLINE M ChordRound(M active) {
    const D d;
    V trial[kParameterCount];
    PointAlong(lanes_.base, lanes_.step, lanes_.share, trial);
    V modelled[kMaximumFitChannels][1];
    ModelOnly(d, problem_, PointOf(d, problem_, trial), modelled);
    V cost = hn::Zero(d);
    V downhill[kParameterCount];
    for (V& component : downhill) component = hn::Zero(d);
    for (std::size_t k = 0; k < problem_.channelCount; ++k) {
      const V residual = hn::Sub(lanes_.channels[k], modelled[k][0]);
      const V weighted = hn::Mul(residual, lanes_.precision[k]);
      cost = hn::MulAdd(weighted, residual, cost);
      for (int i = 0; i < kParameterCount; ++i) {
        downhill[i] = hn::MulAdd(weighted, lanes_.modelled[k][1 + i], downhill[i]);
      }
    }
    AddPrior(d, problem_, trial, downhill, cost);
    for (int i = 0; i < kParameterCount; ++i) downhill[i] = hn::Mul(downhill[i], lanes_.free[i]);
    V step[kParameterCount];
    lanes_.factor.Solve(d, downhill, step);
    return Settle<true>(active, trial, downhill, cost, step);
  }

  // Accepts the trial point, from which `step` leads on, or shortens the old step; writes the lanes
  // that are finished. Returns the others.
  template <bool kChord>
  HWY_INLINE M Settle(M active, const V* trial, const V* downhill, V cost, const V* step) {
    const D d;
    const M accepted = hn::And(active, hn::Le(cost, lanes_.cost));
    const M rejected = hn::AndNot(accepted, active);
    [[maybe_unused]] const V before = lanes_.decrease;
    [[maybe_unused]] const M wasWhole = hn::Eq(lanes_.share, hn::Set(d, T(1)));

    // Rejected: the parabola through both costs and the slope at the base says where to try next.
    const V two = hn::Set(d, T(2));
    const V curvature =
        hn::Div(hn::MulAdd(hn::Mul(two, lanes_.decrease), lanes_.share, hn::Sub(cost, lanes_.cost)),
                hn::Mul(lanes_.share, lanes_.share));
    const V lowest = hn::Div(lanes_.decrease, curvature);
    const V shorter = hn::Max(hn::Mul(lanes_.share, hn::Set(d, T(0.1))),
                              hn::Min(hn::Mul(lanes_.share, hn::Set(d, T(0.5))), lowest));

    V decrease = hn::Zero(d);
    for (int i = 0; i < kParameterCount; ++i) {
      decrease = hn::MulAdd(step[i], downhill[i], decrease);
    }
    lanes_.share = hn::IfThenElse(accepted, hn::Set(d, T(1)), shorter);
    lanes_.cost = hn::IfThenElse(accepted, cost, lanes_.cost);
    lanes_.decrease = hn::IfThenElse(accepted, decrease, lanes_.decrease);
    for (int i = 0; i < kParameterCount; ++i) {
      lanes_.base[i] = hn::IfThenElse(accepted, trial[i], lanes_.base[i]);
      lanes_.step[i] = hn::IfThenElse(accepted, step[i], lanes_.step[i]);
    }

    if constexpr (kChord) {
      // A curved valley: the straight step ends above its floor, but the chord step leads back down
      // to it. The next round tries both together before the step is shortened.
      const M bent = hn::And(rejected, wasWhole);
      lanes_.share = hn::IfThenElse(bent, hn::Set(d, T(1)), lanes_.share);
      V target[kParameterCount];
      PointAlong(trial, step, hn::Set(d, T(1)), target);
      for (int i = 0; i < kParameterCount; ++i) {
        const V both = hn::Sub(target[i], lanes_.base[i]);
        lanes_.step[i] = hn::IfThenElse(bent, both, lanes_.step[i]);
      }
    }

    // Steps too short to matter: the cost is as low as its rounding lets it be.
    const M stuck = hn::And(rejected, hn::Lt(lanes_.share, hn::Set(d, T(1e-3))));
    V limit = hn::Set(d, problem_.tolerance);
    // A chord step is small across a valley even where the way along it is long; only one that is
    // far smaller than the step before tells that the end is near.
    if constexpr (kChord) limit = hn::Min(limit, hn::Mul(before, hn::Set(d, T(0.03))));
    const M small = hn::Lt(decrease, limit);
    const M converged = hn::Or(hn::And(accepted, small), stuck);
    const M finished = hn::Or(converged, hn::And(active, Tired()));
    Write(finished, converged);
    return hn::AndNot(finished, active);
  }

  // Counts the round; lanes that have had as many as they may.
  HWY_INLINE M Tired() {
    const D d;
    HWY_ALIGN T tired[kLanes];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      tired[lane] = ++rounds_[lane] >= static_cast<std::uint32_t>(problem_.maximumRounds) ? T(1)
                                                                                         : T(0);
    }
    return hn::Gt(hn::Load(d, tired), hn::Zero(d));
  }

  // Finished lanes take their last step unseen: it is shorter than what the tolerance lets matter.
  HWY_INLINE void Write(M finished, M converged) {
    const D d;
    if (hn::AllFalse(d, finished)) return;
    HWY_ALIGN T values[kParameterCount][kLanes];
    HWY_ALIGN T flags[2][kLanes];
    const V nothing = hn::Zero(d);
    const V share = hn::IfThenElse(converged, lanes_.share, nothing);
    V last[kParameterCount];
    PointAlong(lanes_.base, lanes_.step, share, last);
    for (int i = 0; i < kParameterCount; ++i) hn::Store(last[i], d, values[i]);
    const V one = hn::Set(d, T(1));
    hn::Store(hn::IfThenElseZero(finished, one), d, flags[0]);
    hn::Store(hn::IfThenElseZero(converged, one), d, flags[1]);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (flags[0][lane] == T(0)) continue;
      const std::size_t pixel = pixel_[lane];
      for (std::size_t i = 0; i < kParameterCount; ++i) {
        batch_.coordinates[i * batch_.stride + pixel] = values[i][lane];
      }
      batch_.converged[pixel] = flags[1][lane] != T(0);
      batch_.rounds[pixel] = static_cast<std::uint16_t>(batch_.rounds[pixel] + rounds_[lane]);
    }
  }

  HWY_INLINE std::size_t PutAside(M active, Straggler<T>* aside) {
    const D d;
    HWY_ALIGN T flags[kLanes];
    HWY_ALIGN T values[2 * kParameterCount + 3][kLanes];
    hn::Store(hn::IfThenElseZero(active, hn::Set(d, T(1))), d, flags);
    for (int i = 0; i < kParameterCount; ++i) {
      hn::Store(lanes_.base[i], d, values[i]);
      hn::Store(lanes_.step[i], d, values[kParameterCount + i]);
    }
    hn::Store(lanes_.share, d, values[2 * kParameterCount]);
    hn::Store(lanes_.cost, d, values[2 * kParameterCount + 1]);
    hn::Store(lanes_.decrease, d, values[2 * kParameterCount + 2]);
    std::size_t count = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (flags[lane] == T(0)) continue;
      Straggler<T>& straggler = aside[count++];
      straggler.pixel = pixel_[lane];
      straggler.rounds = rounds_[lane];
      for (int i = 0; i < kParameterCount; ++i) {
        straggler.base[i] = values[i][lane];
        straggler.step[i] = values[kParameterCount + i][lane];
      }
      straggler.share = values[2 * kParameterCount][lane];
      straggler.cost = values[2 * kParameterCount + 1][lane];
      straggler.decrease = values[2 * kParameterCount + 2][lane];
    }
    return count;
  }

  const RefinedProblem<T>& problem_;
  const RefinedBatch<T>& batch_;
  Lanes<V> lanes_;
  std::uint32_t pixel_[kLanes];
  std::uint32_t rounds_[kLanes];
  std::size_t live_ = 0;
};

template <typename T>
HWY_NOINLINE void Refine(const RefinedProblem<T>& problem, const RefinedBatch<T>& batch) {
  const hn::ScalableTag<T> d;
  using R = Refiner<decltype(d)>;
  constexpr std::size_t lanes = R::kLanes;
  // A vector is left when at most half of its lanes still work; two such halves make a vector.
  constexpr std::size_t patience = lanes / 2;
  Straggler<T> aside[2 * lanes];
  std::size_t waiting = 0;
  R refiner(problem, batch);
  const auto drain = [&](std::size_t atLeast) HWY_ATTR {
    while (waiting >= atLeast && waiting > 0) {
      const std::size_t count = waiting < lanes ? waiting : lanes;
      waiting -= count;
      refiner.Resume(aside + waiting, count);
      waiting += refiner.Run(waiting > 0 || atLeast > 1 ? patience : 0, aside + waiting);
    }
  };
  for (std::size_t first = 0; first < batch.count; first += lanes) {
    const std::size_t live = batch.count - first < lanes ? batch.count - first : lanes;
    refiner.Begin(first, live);
    waiting += refiner.Run(patience, aside + waiting);
    drain(lanes);
  }
  drain(1);
}

void RefineFloat(const RefinedProblem<float>& problem, const RefinedBatch<float>& batch) {
  Refine(problem, batch);
}
void RefineDouble(const RefinedProblem<double>& problem, const RefinedBatch<double>& batch) {
  Refine(problem, batch);
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(RefineFloat);
HWY_EXPORT(RefineDouble);

template <>
void runRefinedKernel(const RefinedProblem<float>& problem, const RefinedBatch<float>& batch) {
  HWY_DYNAMIC_DISPATCH(RefineFloat)(problem, batch);
}

template <>
void runRefinedKernel(const RefinedProblem<double>& problem, const RefinedBatch<double>& batch) {
  HWY_DYNAMIC_DISPATCH(RefineDouble)(problem, batch);
}

}  // namespace cutis
#endif  // HWY_ONCE
