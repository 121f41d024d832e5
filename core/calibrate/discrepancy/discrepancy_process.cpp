#include "core/calibrate/discrepancy/discrepancy_process.h"

#include <algorithm>
#include <cmath>

#include "core/maths/decompositions.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Deviations of the smooth process: in the visible range, and what is added towards the ends.
constexpr double kVisibleDeviation = 0.03;
constexpr double kUltravioletDeviation = 0.10;   // by 320 nm
constexpr double kNearInfraredDeviation = 0.06;  // by 1000 nm
constexpr double kUltravioletFromNm = 400.0, kUltravioletToNm = 320.0;
constexpr double kNearInfraredFromNm = 700.0, kNearInfraredToNm = 1000.0;
// Over which it varies: as wide as the bands of what absorbs in skin.
constexpr double kCorrelationLengthNm = 25.0;
// Added to its variance, that the matrix is definite in numbers, too.
constexpr double kVarianceFloor = 1e-8;
// Readings vary by a share of themselves and by an amount.
constexpr double kReadingShare = 0.003, kReadingAmount = 0.0005;

double smoothDeviation(double wavelength) {
  const double ultraviolet =
      (kUltravioletFromNm - wavelength) / (kUltravioletFromNm - kUltravioletToNm);
  const double nearInfrared =
      (wavelength - kNearInfraredFromNm) / (kNearInfraredToNm - kNearInfraredFromNm);
  return kVisibleDeviation + kUltravioletDeviation * std::clamp(ultraviolet, 0.0, 1.0) +
         kNearInfraredDeviation * std::clamp(nearInfrared, 0.0, 1.0);
}

MatrixXd smoothCovariance() {
  MatrixXd covariance(kWorkingCount, kWorkingCount);
  for (Index i = 0; i < kWorkingCount; ++i) {
    const double wavelength = wavelengthNm(gridSample(i));
    for (Index j = 0; j < kWorkingCount; ++j) {
      const double other = wavelengthNm(gridSample(j));
      const double apart = (wavelength - other) / kCorrelationLengthNm;
      covariance(i, j) =
          smoothDeviation(wavelength) * smoothDeviation(other) * std::exp(-0.5 * apart * apart);
    }
  }
  covariance.diagonal().array() += kVarianceFloor;
  return covariance;
}

}  // namespace

MatrixXd DiscrepancyProcess::totalCovariance() const {
  return covariance + slope * people.covariance * slope.transpose();
}

DiscrepancyProcess smoothProcess(const CoordinateDistribution& people) {
  return {people, VectorXd::Zero(kWorkingCount), MatrixXd::Zero(kWorkingCount, kParameterCount),
          smoothCovariance()};
}

DiscrepancyProcess extended(const DiscrepancyProcess& learned, std::span<const Index> at) {
  const MatrixXd smooth = smoothCovariance();
  const auto count = static_cast<Index>(at.size());
  // Regression of all samples on those that were learned. These are taken as readings, for the
  // smooth process alone would follow their noise out to where nothing holds it.
  MatrixXd known = smooth(at, at);
  known.diagonal().array() += kReadingShare * kReadingShare;
  const MatrixXd across = smooth(Eigen::all, at);
  MatrixXd regression = solvePositive(known, across.transpose()).transpose();
  MatrixXd left = smooth - regression * across.transpose() - across * regression.transpose() +
                  regression * smooth(at, at) * regression.transpose();
  for (Index i = 0; i < count; ++i) {
    const Index sample = at[static_cast<std::size_t>(i)];
    regression.row(sample).setZero();
    regression(sample, i) = 1.0;
    left.row(sample).setZero();
    left.col(sample).setZero();
  }
  const MatrixXd covariance = regression * learned.covariance * regression.transpose() + left;
  return {learned.people, regression * learned.mean, regression * learned.slope,
          0.5 * (covariance + covariance.transpose())};
}

double readingVariance(double measured) {
  const double amount = kReadingAmount / measured;
  return kReadingShare * kReadingShare + amount * amount;
}

MatrixXd toGrid(const MatrixXd& working) {
  MatrixXd grid(int{kSampleCount}, working.cols());
  for (Index i = 0; i < kSampleCount; ++i) {
    const Index below = std::min<Index>(i / kWorkingStep, kWorkingCount - 2);
    const double share = static_cast<double>(i - gridSample(below)) / kWorkingStep;
    grid.row(i) = (1.0 - share) * working.row(below) + share * working.row(below + 1);
  }
  return grid;
}

}  // namespace cutis
