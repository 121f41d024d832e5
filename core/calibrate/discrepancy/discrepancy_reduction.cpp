#include "core/calibrate/discrepancy/discrepancy_reduction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

// What no coefficient tells, of covariance `over`: the leading spectra, and beside them, wavelength
// by wavelength, the rest of its variance, or of what people left out have if that is more.
void setRest(Discrepancy& discrepancy, const MatrixXd& over, const VectorXd& reflectance,
             const VectorXd& leftOut) {
  const Leading others = leading(over, reflectance, kRestCount);
  const MatrixXd spectra = reflectance.cwiseInverse().asDiagonal() * others.vectors *
                           others.variance.cwiseSqrt().asDiagonal();
  const VectorXd all = over.diagonal().cwiseMax(leftOut);
  const VectorXd independent = (all - spectra.rowwise().squaredNorm()).cwiseMax(0.0).cwiseSqrt();
  discrepancy.rest = toGrid(spectra);
  discrepancy.independentDeviation = toGrid(independent).col(0).array();
}

}  // namespace

std::vector<Index> seenOf(std::span<const Index> at) {
  std::vector<Index> seen;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double wavelength = wavelengthNm(gridSample(at[i]));
    if (wavelength >= kSeenFromNm && wavelength <= kSeenToNm) seen.push_back(static_cast<Index>(i));
  }
  return seen;
}

VectorXd typicalReflectance(const DiscrepancyProcess& process, const SkinModel& model,
                            const Prior& like) {
  const Prior prior = priorFrom(process.people, like);
  VectorXd reflectance(kWorkingCount);
  for (Index i = 0; i < kWorkingCount; ++i)
    reflectance[i] = model.reflectanceAt(gridSample(i), prior.mean);
  return reflectance;
}

SeenComponents seenComponents(const MatrixXd& covariance, const VectorXd& reflectance,
                              const std::vector<Index>& seen, int count) {
  const Leading main = leading(covariance(seen, seen), reflectance(seen), count);
  SeenComponents result;
  // Coefficients are linear in what is seen of the discrepancy.
  result.coefficients = main.variance.cwiseSqrt().cwiseInverse().asDiagonal() *
                        main.vectors.transpose() * reflectance(seen).asDiagonal();
  result.spectra = covariance(Eigen::all, seen) * result.coefficients.transpose();
  return result;
}

Discrepancy reduced(const DiscrepancyProcess& process, const VectorXd& reflectance,
                    const VectorXd& leftOut, int components, const Prior& like) {
  std::vector<Index> all(std::size_t{kWorkingCount});
  std::iota(all.begin(), all.end(), Index{0});
  const std::vector<Index> seen = seenOf(all);
  const MatrixXd total = process.totalCovariance();
  const SeenComponents main = seenComponents(total, reflectance, seen, components);
  const MatrixXd& coefficients = main.coefficients;
  const MatrixXd over = total - main.spectra * main.spectra.transpose();

  Discrepancy discrepancy;
  discrepancy.mean = toGrid(process.mean).col(0).array();
  discrepancy.components = toGrid(main.spectra);
  discrepancy.slope = coefficients * process.slope(seen, Eigen::all);
  discrepancy.covariance =
      symmetric(coefficients * process.covariance(seen, seen) * coefficients.transpose());
  setRest(discrepancy, over, reflectance, leftOut);
  discrepancy.prior = priorFrom(process.people, like);
  keepPositive(discrepancy);
  return discrepancy;
}

}  // namespace cutis
