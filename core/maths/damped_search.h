#pragma once

// Bounded least squares by damped Gauss–Newton steps in the unit box: what the searches for spectra
// (core/fit/spectra/spectra_search.h) and for pixels with free constants
// (core/fit/free/free_search.h) have in common.
//
// A search knows the normal equations of the best point so far, its base; the caller knows the
// point itself and how a step leads on from it. Not thread-safe; each search is its own.

#include <cstddef>
#include <limits>
#include <vector>

#include "core/maths/bounded_step.h"
#include "core/maths/damping.h"
#include "core/maths/equation_sums.h"

namespace cutis {

struct DampedSearchRules {
  int maximumRounds = 100;
  double leastDamping = 1e-12;  // as in Damping
  // Steps with more damping than this are so short that they are lost in rounding.
  double mostDamping = 1e10;
  // A small promise of a damped step ends the search where the undamped one promises little, too,
  // or from this damping on. For where slopes jump: there the quadratic promises for ever.
  double disproof = std::numeric_limits<double>::infinity();
};

template <int N>
class DampedSearch {
 public:
  using Vector = typename EquationsOf<N>::Vector;

  explicit DampedSearch(const DampedSearchRules& rules)
      : rules_(rules), damping_(rules.leastDamping) {
    base_.cost = std::numeric_limits<double>::infinity();
  }

  // At the base; infinite before there is one.
  double cost() const { return base_.cost; }
  int rounds() const { return rounds_; }
  bool converged() const { return converged_; }

  // Whether a trial of this cost is no worse than the base. Then it becomes the base by accept();
  // else reject() shortens the next step.
  bool improves(double cost) const { return cost <= base_.cost; }
  void accept(const EquationsOf<N>& equations) {
    damping_.accept(base_.cost - equations.cost, promised_);
    base_ = equations;
  }
  void reject() { damping_.reject(); }

  // Sets out from the base, which lies at x in the unit box. False: the search is over, as nothing
  // is left to gain but `enough` (converged) or its rounds are.
  bool next(const Vector& x, double enough, Vector& step) {
    const BoundedStep<N> bounded = stepFrom(x, damping_.value());
    const bool disproved = damping_.value() >= rules_.disproof;
    // Damping shortens steps; only without it a small promise means that the end is reached.
    converged_ = bounded.decrease <= enough && (disproved || stepFrom(x, 0.0).decrease <= enough);
    if (converged_ || ++rounds_ > rules_.maximumRounds || damping_.value() > rules_.mostDamping) {
      return false;
    }
    promised_ = bounded.decrease;
    step = bounded.step;
    return true;
  }

 private:
  BoundedStep<N> stepFrom(const Vector& x, double damping) const {
    typename EquationsOf<N>::Matrix damped = base_.hessian;
    damped.diagonal() *= 1.0 + damping;
    return boundedStep<N>(damped, base_.downhill, x);
  }

  DampedSearchRules rules_;
  EquationsOf<N> base_;
  Damping damping_;
  double promised_ = 0.0;
  int rounds_ = 0;
  bool converged_ = false;
};

// All searches side by side, so that the model is evaluated for many at once: evaluate(active) says
// what the trial of each active search came to, and advance(search, came) whether it goes on. Ends
// when none does or stopped() is true; returns whether all came to their end.
template <typename Search, typename Evaluate, typename Advance, typename Stopped>
bool runSearches(std::vector<Search>& searches, const Evaluate& evaluate, const Advance& advance,
                 const Stopped& stopped) {
  std::vector<Search*> active;
  for (Search& search : searches)
    active.push_back(&search);
  while (!active.empty()) {
    if (stopped()) return false;
    const auto came = evaluate(active);
    std::size_t left = 0;
    for (std::size_t i = 0; i < active.size(); ++i) {
      if (advance(*active[i], came[i])) active[left++] = active[i];
    }
    active.resize(left);
  }
  return true;
}

}  // namespace cutis
