#include "core/evaluate/error_bound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>

#include "core/base/parallel.h"

namespace cutis {
namespace {

using ParameterColumns = Eigen::Matrix<double, Eigen::Dynamic, kParameterCount>;

constexpr std::size_t kPeopleAtOnce = 16;

// Mean of diag(G C Gᵀ).
double meanVariance(const ParameterColumns& g, const ParameterMatrix& covariance,
                    const Band& band) {
  const auto part = g.middleRows(band.first, band.count());
  return (part * covariance).cwiseProduct(part).sum() / band.count();
}

ErrorBound boundOf(const Eigen::VectorXd& channels, const ParameterColumns& j,
                   const ParameterColumns& g, const Prior& prior, double noise) {
  ParameterMatrix information = ParameterMatrix::Zero();
  information.diagonal() = prior.deviation.square().inverse().matrix();
  for (Eigen::Index k = 0; k < channels.size(); ++k) {
    if (channels[k] <= 0.0) continue;
    const double precision = 1.0 / std::pow(noise * channels[k], 2);
    information.noalias() += precision * j.row(k).transpose() * j.row(k);
  }
  // Parameters differ by orders of magnitude: scaled by the prior they do not.
  const auto scale = prior.deviation.matrix().asDiagonal();
  const ParameterMatrix scaled = scale * information * scale;
  const ParameterMatrix covariance =
      scale * scaled.llt().solve(ParameterMatrix::Identity()) * scale;
  return {meanVariance(g, covariance, kVisibleBand), meanVariance(g, covariance, kUltravioletBand),
          meanVariance(g, covariance, kNearInfraredBand)};
}

}  // namespace

Result<std::vector<ErrorBound>> errorBounds(const SkinModel& model, const Rig& rig,
                                            std::span<const ParameterVector> people,
                                            const Prior& prior, std::span<const double> noises,
                                            const JobContext& context) {
  const Eigen::MatrixXd rows = responseRows(rig).matrix();
  std::vector<ErrorBound> each(people.size() * noises.size());
  CUTIS_CHECK(
      parallelFor((people.size() + kPeopleAtOnce - 1) / kPeopleAtOnce, context,
                  [&](std::size_t piece) -> Status {
                    const std::size_t end = std::min(people.size(), (piece + 1) * kPeopleAtOnce);
                    for (std::size_t i = piece * kPeopleAtOnce; i < end; ++i) {
                      SpectrumJacobian derivatives;
                      const Spectrum reflectance = model.reflectance(people[i], derivatives);
                      const ParameterColumns g = derivatives.matrix();
                      const ParameterColumns j = rows * g;
                      const Eigen::VectorXd channels = rows * reflectance.matrix();
                      for (std::size_t n = 0; n < noises.size(); ++n)
                        each[i * noises.size() + n] = boundOf(channels, j, g, prior, noises[n]);
                    }
                    return {};
                  }));
  std::vector<ErrorBound> means(noises.size());
  const auto count = static_cast<double>(people.size());
  for (std::size_t i = 0; i < each.size(); ++i) {
    ErrorBound& mean = means[i % noises.size()];
    mean.visible += each[i].visible / count;
    mean.ultraviolet += each[i].ultraviolet / count;
    mean.nearInfrared += each[i].nearInfrared / count;
  }
  return means;
}

}  // namespace cutis
