#pragma once  // internal to core/fit/free

// Maximum a posteriori estimates of pixels with constants of the profile as further coordinates:
// the inner part of core/fit/free/free_solver.cpp.
//
// The objective is that of core/fit/reference/map_estimator.h with the prior of
// core/fit/free/free_prior.h added; steps are damped Gauss–Newton with bounds. A point is a pixel's
// coordinates, each measured along its range from 0 to 1: parameters or their logarithms
// (core/fit/coordinate_prior.h), then those of the free constants
// (core/skin/free/free_coordinates.h).

#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/pixel_rows.h"
#include "core/fit/coordinate_prior.h"
#include "core/fit/free/free_prior.h"
#include "core/maths/equation_sums.h"
#include "core/rig/rig.h"
#include "core/skin/free/free_response.h"

namespace cutis {

struct FreeProblem {
  std::shared_ptr<const FreeResponse> channels;  // those without weights are left out
  CoordinatePrior parameters;
  FreePrior constants;
  NoiseModel noise;  // not exact
};

// N: 5 and the number of free constants. Thread-safe: const after construction.
template <int N>
class FreeEstimator {
 public:
  using Point = Eigen::Matrix<double, N, 1>;

  explicit FreeEstimator(FreeProblem problem);

  // values: the parameters and the free constants in their units, and back.
  Point pointOf(const double* values) const;
  void valuesOf(const Point& point, double* values) const;
  // The mean of the prior.
  const Point& mean() const { return mean_; }

  // Around a point: what the quadratic says of the cost, and how much of it is the channels'.
  struct Linearised {
    EquationsOf<N> equations;
    double channelCost = 0.0;
  };
  // pixels[i]: where point i is measured among the channels.
  std::vector<Linearised> linearise(std::span<const Point> points,
                                    std::span<const std::size_t> pixels,
                                    PixelRows<const float> channels) const;

  // Posterior standard deviations at a point, in the values' units; 0 for what is held.
  void deviationsAt(const Point& point, const EquationsOf<N>& equations, double* deviations) const;

  // A misfit of the channels beyond this is no noise.
  double mostChannelCost() const;

 private:
  // Values of the nodes, then their slopes by each coordinate: [node][1 + N][point].
  std::vector<double> nodeValues(std::span<const Point> points) const;
  void addPrior(const Point& point, EquationsOf<N>& equations) const;
  SkinConstants constantsAt(const Point& point) const;

  FreeProblem problem_;
  std::vector<std::size_t> channels_;        // that see something
  std::vector<double> weights_;              // of these: [channel][node]
  Eigen::Matrix<double, N, 1> low_, range_;  // of the coordinates
  Point mean_ = Point::Zero();
  Eigen::Matrix<double, N, N> precision_ = Eigen::Matrix<double, N, N>::Zero();  // of the prior
};

extern template class FreeEstimator<kParameterCount + 1>;
extern template class FreeEstimator<kParameterCount + 2>;

}  // namespace cutis
