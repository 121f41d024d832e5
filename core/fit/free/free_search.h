#pragma once  // internal to core/fit/free

// Searches of many pixels side by side: an inner part of core/fit/free/free_solver.cpp.

#include <cstddef>
#include <limits>
#include <vector>

#include "core/fit/free/free_estimator.h"
#include "core/maths/bounded_step.h"
#include "core/maths/damping.h"

namespace cutis {

// A search for one pixel, from one start.
template <int N>
class FreeSearch {
 public:
  using Estimator = FreeEstimator<N>;
  using Point = typename Estimator::Point;

  FreeSearch(std::size_t pixel, const Point& start) : pixel_(pixel), trial_(start) {}

  std::size_t pixel() const { return pixel_; }  // in the batch
  const Point& trial() const { return trial_; }
  const Point& point() const { return point_; }
  double cost() const { return at_.equations.cost; }
  double channelCost() const { return at_.channelCost; }
  int rounds() const { return rounds_; }
  bool converged() const { return converged_; }

  // Takes in what the trial came to and sets out for the next; false when there is none. tolerance:
  // done when another step would lower the cost by less.
  bool advance(const typename Estimator::Linearised& atTrial, double tolerance, int maximumRounds) {
    if (atTrial.equations.cost <= at_.equations.cost) {
      damping_.accept(at_.equations.cost - atTrial.equations.cost, promised_);
      point_ = trial_;
      at_ = atTrial;
    } else {
      damping_.reject();
    }
    const BoundedStep<N> next = step(damping_.value());
    // A promise is believed until it was broken: where the slope jumps, such as where the blood of
    // the epidermis meets full oxygenation, the quadratic promises for ever.
    const bool disproved = damping_.value() >= 1.0;
    converged_ = next.decrease <= tolerance && (disproved || step(0.0).decrease <= tolerance);
    if (converged_ || ++rounds_ > maximumRounds) return false;
    promised_ = next.decrease;
    trial_ = (point_ + next.step).cwiseMax(0.0).cwiseMin(1.0);
    return true;
  }

 private:
  BoundedStep<N> step(double damping) const {
    typename EquationsOf<N>::Matrix damped = at_.equations.hessian;
    damped.diagonal() *= 1.0 + damping;
    return boundedStep<N>(damped, at_.equations.downhill, point_);
  }

  std::size_t pixel_;
  Point trial_, point_ = Point::Zero();
  typename Estimator::Linearised at_ = {{.cost = std::numeric_limits<double>::infinity()}, 0.0};
  Damping damping_{1e-4};
  double promised_ = 0.0;
  int rounds_ = 0;
  bool converged_ = false;
};

// All together, so that the model is evaluated for many at once.
template <int N>
void runSearches(const FreeEstimator<N>& estimator, const PixelBatch& batch, double tolerance,
                 int maximumRounds, std::vector<FreeSearch<N>>& searches) {
  std::vector<FreeSearch<N>*> active;
  for (FreeSearch<N>& search : searches)
    active.push_back(&search);
  std::vector<typename FreeEstimator<N>::Point> points;
  std::vector<std::size_t> pixels;
  while (!active.empty()) {
    points.clear();
    pixels.clear();
    for (const FreeSearch<N>* search : active) {
      points.push_back(search->trial());
      pixels.push_back(search->pixel());
    }
    const auto linearised = estimator.linearise(points, pixels, batch);
    std::size_t left = 0;
    for (std::size_t i = 0; i < active.size(); ++i) {
      if (active[i]->advance(linearised[i], tolerance, maximumRounds)) active[left++] = active[i];
    }
    active.resize(left);
  }
}

}  // namespace cutis
