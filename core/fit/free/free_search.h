#pragma once  // internal to core/fit/free

// Searches of many pixels side by side: an inner part of core/fit/free/free_solver.cpp.

#include <cstddef>
#include <limits>

#include "core/fit/free/free_estimator.h"
#include "core/maths/damped_search.h"

namespace cutis {

// A search for one pixel, from one start.
template <int N>
class FreeSearch {
 public:
  using Estimator = FreeEstimator<N>;
  using Point = typename Estimator::Point;

  FreeSearch(std::size_t pixel, const Point& start, int maximumRounds)
      : pixel_(pixel), trial_(start), search_(rules(maximumRounds)) {}

  std::size_t pixel() const { return pixel_; }
  const Point& trial() const { return trial_; }
  const Point& point() const { return point_; }
  double cost() const { return search_.cost(); }
  double channelCost() const { return channelCost_; }
  int rounds() const { return search_.rounds(); }
  bool converged() const { return search_.converged(); }

  // Takes in what the trial came to and sets out for the next; false when there is none. tolerance:
  // done when another step would lower the cost by less.
  bool advance(const typename Estimator::Linearised& atTrial, double tolerance) {
    if (search_.improves(atTrial.equations.cost)) {
      search_.accept(atTrial.equations);
      point_ = trial_;
      channelCost_ = atTrial.channelCost;
    } else {
      search_.reject();
    }
    Point step;
    if (!search_.next(point_, tolerance, step)) return false;
    trial_ = (point_ + step).cwiseMax(0.0).cwiseMin(1.0);
    return true;
  }

 private:
  // Slopes jump where the blood of the epidermis meets full oxygenation: there a promise is
  // believed until it was broken, and steps are never too short to be tried.
  static DampedSearchRules rules(int maximumRounds) {
    return {.maximumRounds = maximumRounds,
            .leastDamping = 1e-4,
            .mostDamping = std::numeric_limits<double>::infinity(),
            .disproof = 1.0};
  }

  std::size_t pixel_;
  Point trial_, point_ = Point::Zero();
  double channelCost_ = 0.0;
  DampedSearch<N> search_;
};

}  // namespace cutis
