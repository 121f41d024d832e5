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
  V decrease;               // of the cost that the whole step promises, halved
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
      M converged;
      const M finished = Round(active, converged);
      Write(finished, converged);
      active = hn::AndNot(finished, active);
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
  HWY_INLINE void Hold(const V* trial, NormalEquations<V>& normal) const {
    const D d;
    for (int i = 0; i < kParameterCount; ++i) {
      const V down = normal.downhill[i];
      const M below = hn::And(hn::Le(trial[i], hn::Set(d, problem_.low[i])), hn::Le(down, hn::Zero(d)));
      const M above = hn::And(hn::Ge(trial[i], hn::Set(d, problem_.high[i])), hn::Ge(down, hn::Zero(d)));
      M held = hn::Or(below, above);
      if (problem_.isFixed[i]) held = hn::Eq(down, down);
      if (!hn::AllFalse(d, held)) normal.Hold(d, i, held);
    }
  }

  // One round of the active lanes; returns those that are finished and, of these, the converged.
  HWY_INLINE M Round(M active, M& converged) {
    const D d;
    const V one = hn::Set(d, T(1));
    V trial[kParameterCount];
    for (int i = 0; i < kParameterCount; ++i) {
      trial[i] = Boxed(i, hn::MulAdd(lanes_.share, lanes_.step[i], lanes_.base[i]));
      if (problem_.isFixed[i]) trial[i] = lanes_.base[i];
    }
    NormalEquations<V> normal;
    Linearise(d, problem_, lanes_.channels, lanes_.precision, trial, normal);
    const M accepted = hn::And(active, hn::Le(normal.cost, lanes_.cost));
    const M rejected = hn::AndNot(accepted, active);

    // Rejected: the parabola through both costs and the slope at the base says where to try next.
    const V curvature = hn::Div(
        hn::MulAdd(hn::Mul(hn::Set(d, T(2)), lanes_.decrease), lanes_.share,
                   hn::Sub(normal.cost, lanes_.cost)),
        hn::Mul(lanes_.share, lanes_.share));
    V shorter = hn::Div(lanes_.decrease, curvature);
    shorter = hn::Max(hn::Mul(lanes_.share, hn::Set(d, T(0.1))),
                      hn::Min(hn::Mul(lanes_.share, hn::Set(d, T(0.5))), shorter));

    Hold(trial, normal);
    V step[kParameterCount];
    normal.Solve(d, step);
    V decrease = hn::Zero(d);
    for (int i = 0; i < kParameterCount; ++i) {
      decrease = hn::MulAdd(step[i], normal.downhill[i], decrease);
    }

    lanes_.share = hn::IfThenElse(accepted, one, shorter);
    lanes_.cost = hn::IfThenElse(accepted, normal.cost, lanes_.cost);
    lanes_.decrease = hn::IfThenElse(accepted, decrease, lanes_.decrease);
    for (int i = 0; i < kParameterCount; ++i) {
      lanes_.base[i] = hn::IfThenElse(accepted, trial[i], lanes_.base[i]);
      lanes_.step[i] = hn::IfThenElse(accepted, step[i], lanes_.step[i]);
    }
    M tired = hn::FirstN(d, 0);
    HWY_ALIGN T tiredLanes[kLanes] = {};
    bool anyTired = false;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (++rounds_[lane] >= static_cast<std::uint32_t>(problem_.maximumRounds)) {
        tiredLanes[lane] = T(1);
        anyTired = true;
      }
    }
    if (anyTired) tired = hn::And(active, hn::Gt(hn::Load(d, tiredLanes), hn::Zero(d)));
    // Steps too short to matter: the cost is as low as its rounding lets it be.
    const M stuck = hn::And(rejected, hn::Lt(lanes_.share, hn::Set(d, T(1e-3))));
    converged = hn::Or(hn::And(accepted, hn::Lt(decrease, hn::Set(d, problem_.tolerance))), stuck);
    return hn::Or(converged, tired);
  }

  // Finished lanes take their last step unseen: it is shorter than what the tolerance lets matter.
  HWY_INLINE void Write(M finished, M converged) {
    const D d;
    if (hn::AllFalse(d, finished)) return;
    HWY_ALIGN T values[kParameterCount][kLanes];
    HWY_ALIGN T flags[2][kLanes];
    const V nothing = hn::Zero(d);
    const V share = hn::IfThenElse(converged, lanes_.share, nothing);
    for (int i = 0; i < kParameterCount; ++i) {
      const V last = Boxed(i, hn::MulAdd(share, lanes_.step[i], lanes_.base[i]));
      hn::Store(problem_.isFixed[i] ? lanes_.base[i] : last, d, values[i]);
    }
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
