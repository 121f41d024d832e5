#include "core/calibrate/discrepancy_reduction.h"

#include <cmath>

#include "core/maths/decompositions.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What cameras see.
constexpr double kSeenFromNm = 380.0, kSeenToNm = 740.0;
constexpr int kRestCount = 8;

// The leading eigenvectors of a covariance of relative reflectance, times roots of their values,
// where errors count as those of reflectance do. Signs are such that sums are positive.
struct Leading {
  MatrixXd vectors;   // of unit length, [sample][i]
  VectorXd variance;  // decreasing
};
Leading leading(const MatrixXd& covariance, const VectorXd& reflectance, int count) {
  const auto weights = reflectance.asDiagonal();
  const SymmetricEigen eigen = symmetricEigen(weights * covariance * weights);
  const Index all = eigen.values.size();
  Leading result = {MatrixXd(all, count), VectorXd(count)};
  for (Index i = 0; i < count; ++i) {
    result.vectors.col(i) = eigen.vectors.col(all - 1 - i);
    if (result.vectors.col(i).sum() < 0.0) result.vectors.col(i) *= -1.0;
    result.variance[i] = std::max(eigen.values[all - 1 - i], 0.0);
  }
  return result;
}

MatrixXd symmetric(const MatrixXd& matrix) {
  return 0.5 * (matrix + matrix.transpose());
}

// Where hardly any light comes back, coefficients within their limit must not turn it negative.
void keepPositive(Discrepancy& discrepancy) {
  for (Index i = 0; i < int{kSampleCount}; ++i) {
    const double room = 1.0 + discrepancy.mean[i] - kLeastFactor;
    const double most = kMostCoefficientNorm * discrepancy.components.row(i).norm();
    if (most > room) discrepancy.components.row(i) *= 0.99 * room / most;
  }
}

}  // namespace

Discrepancy reduced(const DiscrepancyProcess& process, const SkinModel& model, int components,
                    const Prior& like) {
  const Prior prior = priorFrom(process.people, like);
  VectorXd reflectance(kWorkingCount);
  std::vector<Index> seen;
  for (Index i = 0; i < kWorkingCount; ++i) {
    const double wavelength = wavelengthNm(gridSample(i));
    reflectance[i] = model.reflectanceAt(gridSample(i), prior.mean);
    if (wavelength >= kSeenFromNm && wavelength <= kSeenToNm) seen.push_back(i);
  }
  const MatrixXd total = process.totalCovariance();
  const Leading main = leading(total(seen, seen), reflectance(seen), components);
  // Coefficients are linear in what is seen of the discrepancy.
  const MatrixXd coefficients = main.variance.cwiseSqrt().cwiseInverse().asDiagonal() *
                                main.vectors.transpose() * reflectance(seen).asDiagonal();
  const MatrixXd spectra = total(Eigen::all, seen) * coefficients.transpose();
  const MatrixXd over = total - spectra * spectra.transpose();
  const Leading others = leading(over, reflectance, kRestCount);
  const MatrixXd rest = reflectance.cwiseInverse().asDiagonal() * others.vectors *
                        others.variance.cwiseSqrt().asDiagonal();

  Discrepancy discrepancy;
  discrepancy.mean = toGrid(process.mean).col(0).array();
  discrepancy.components = toGrid(spectra);
  discrepancy.slope = coefficients * process.slope(seen, Eigen::all);
  discrepancy.covariance =
      symmetric(coefficients * process.covariance(seen, seen) * coefficients.transpose());
  discrepancy.rest = toGrid(rest);
  discrepancy.prior = prior;
  keepPositive(discrepancy);
  return discrepancy;
}

}  // namespace cutis
