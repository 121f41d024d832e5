#include "core/analyse/identifiability.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>

#include "core/base/parallel.h"
#include "core/maths/decompositions.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kBatch = 16;
constexpr double kDecided = 0.5;

// Channels that see something, as rows.
MatrixXd seeing(const ChannelSet& channels) {
  const MatrixXd measured = channels.rows.matrix();
  const Index count = (measured.array() != 0.0).rowwise().any().count();
  MatrixXd rows(count, measured.cols());
  Index next = 0;
  for (Index k = 0; k < measured.rows(); ++k) {
    if ((measured.row(k).array() != 0.0).any()) rows.row(next++) = measured.row(k);
  }
  return rows;
}

// Jᵀ Σ⁻¹ J.
ParameterMatrix informationOf(const MatrixXd& j, const VectorXd& channels, const ChannelSet& set) {
  const VectorXd variance =
      (channels.array() * set.noise.proportional).square() + set.noise.read * set.noise.read;
  if (set.combination.size() == 0) {
    return j.transpose() * variance.cwiseInverse().asDiagonal() * j;
  }
  const MatrixXd combined = set.combination * j;
  const MatrixXd covariance = set.combination * variance.asDiagonal() * set.combination.transpose();
  return combined.transpose() * solvePositive(covariance, combined);
}

// Rows and columns measured in the prior's deviations: parameters differ by orders of magnitude.
ParameterMatrix covarianceOf(const ParameterMatrix& information, const ParameterVector& unit) {
  const auto scale = unit.matrix().asDiagonal();
  const ParameterMatrix scaled = scale * information * scale;
  return scale * scaled.llt().solve(ParameterMatrix::Identity()) * scale;
}

template <typename Derivatives>
double meanVariance(const Derivatives& g, const ParameterMatrix& covariance, const Band& band) {
  const auto part = g.middleRows(band.first, band.count());
  return (part * covariance).cwiseProduct(part).sum() / band.count();
}

Spread spreadOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {at(0.05), at(0.5), at(0.95)};
}

}  // namespace

Result<IdentifiabilityStudy> IdentifiabilityStudy::create(const SkinModel& model,
                                                          const Prior& prior,
                                                          std::span<const ParameterVector> people,
                                                          const JobContext& context) {
  assert(!people.empty());
  IdentifiabilityStudy study;
  study.priorPrecision_ = prior.precision();
  study.priorDeviation_ = prior.deviation;
  study.reflectances_.resize(people.size());
  study.derivatives_.resize(people.size());
  CUTIS_CHECK(
      parallelFor((people.size() + kBatch - 1) / kBatch, context, [&](std::size_t piece) -> Status {
        const std::size_t end = std::min(people.size(), (piece + 1) * kBatch);
        for (std::size_t i = piece * kBatch; i < end; ++i) {
          SpectrumJacobian derivatives;
          study.reflectances_[i] = model.reflectance(people[i], derivatives);
          study.derivatives_[i] = derivatives.matrix();
          for (int k = 0; k < kParameterCount; ++k) {
            if (prior.isLog(k)) study.derivatives_[i].col(k) *= people[i][k];
          }
        }
        return {};
      }));
  return study;
}

Identifiability IdentifiabilityStudy::of(const ChannelSet& channels) const {
  assert(!channels.noise.isExact());
  ChannelSet set = channels;
  const MatrixXd rows = set.combination.size() == 0 ? seeing(channels) : channels.rows.matrix();
  std::array<std::vector<double>, kParameterCount> left;
  Identifiability result;
  const auto count = static_cast<double>(reflectances_.size());
  for (std::size_t i = 0; i < reflectances_.size(); ++i) {
    const MatrixXd j = rows * derivatives_[i];
    const ParameterMatrix covariance = covarianceOf(
        priorPrecision_ + informationOf(j, rows * reflectances_[i].matrix(), set), priorDeviation_);
    for (int k = 0; k < kParameterCount; ++k) {
      const double share = std::sqrt(covariance(k, k)) / priorDeviation_[k];
      left[static_cast<std::size_t>(k)].push_back(share);
      result.decidedShare[static_cast<std::size_t>(k)] += share < kDecided ? 1.0 / count : 0.0;
    }
    result.visible += meanVariance(derivatives_[i], covariance, kVisibleBand) / count;
    result.ultraviolet += meanVariance(derivatives_[i], covariance, kUltravioletBand) / count;
    result.nearInfrared += meanVariance(derivatives_[i], covariance, kNearInfraredBand) / count;
  }
  for (std::size_t k = 0; k < left.size(); ++k)
    result.left[k] = spreadOf(std::move(left[k]));
  for (double* mean : {&result.visible, &result.ultraviolet, &result.nearInfrared}) {
    *mean = std::sqrt(*mean);
  }
  return result;
}

}  // namespace cutis
