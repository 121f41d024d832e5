#pragma once

// A discrepancy (core/skin/profile/discrepancy.h) before it is reduced to a few components: a
// Gaussian process, relative to the model's reflectance, at every second sample of the grid.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/calibrate/discrepancy/coordinate_distribution.h"
#include "core/spectra/grid.h"

namespace cutis {

// δ(λ) = mean + slope · (x − people.mean) + what varies by `covariance`, independent of x. Vectors
// and rows are over working samples.
struct DiscrepancyProcess {
  CoordinateDistribution people;  // of whom it was learned
  Eigen::VectorXd mean;
  Eigen::MatrixXd slope;  // [sample][parameter]
  Eigen::MatrixXd covariance;

  // The covariance of all that varies, people included.
  Eigen::MatrixXd totalCovariance() const;
};

inline constexpr int kWorkingStep = 2;  // samples of the grid
inline constexpr int kWorkingCount = (kSampleCount - 1) / kWorkingStep + 1;
inline constexpr int gridSample(Eigen::Index working) {
  return static_cast<int>(working) * kWorkingStep;
}

// What is believed before anybody was measured: no mean, no slope, and a smooth process that is
// wider towards the ends of the grid, where models of skin are known to be worse.
DiscrepancyProcess smoothProcess(const CoordinateDistribution& people);

// The process of all working samples from one that was learned at some of them: the others follow
// from the nearest as they do in the smooth process, with the variance that it leaves them. Of
// `learned`, vectors and rows are over `at`, increasing positions among the working samples.
DiscrepancyProcess extended(const DiscrepancyProcess& learned, std::span<const Eigen::Index> at);

// Variance of a relative reflectance that was measured, errors of reading and of the white: what
// no process explains. measured > 0.
double readingVariance(double measured);

// Columns over working samples to the grid: linear in between.
Eigen::MatrixXd toGrid(const Eigen::MatrixXd& working);

}  // namespace cutis
