#include "core/spectra/spectral_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Least squares of the rows' values Y on the candidates' values X, through the normal equations:
// choosing needs only X'X, X'Y and |Y|².
class Selection {
 public:
  Selection(const MatrixXd& x, const MatrixXd& y)
      : gram_(x.transpose() * x), cross_(x.transpose() * y), total_(y.squaredNorm()) {
    // Far below any error of interest; keeps near-copies of a node from being chosen for noise.
    gram_.diagonal().array() += 1e-13 * gram_.diagonal().maxCoeff();
  }

  Index candidateCount() const { return gram_.rows(); }

  double squaredError(const std::vector<Index>& chosen) const {
    const auto [gram, cross] = part(chosen);
    return total_ - (cross.array() * gram.ldlt().solve(cross).array()).sum();
  }

  // The candidate that lowers the error most when added to `chosen`, and the error it leaves:
  // each candidate's residual against the chosen ones, by one Schur complement for all.
  Index best(const std::vector<Index>& chosen, double& errorLeft) const {
    MatrixXd residualCross = cross_;
    Eigen::VectorXd residualGram = gram_.diagonal();
    double error = total_;
    if (!chosen.empty()) {
      const auto [gram, cross] = part(chosen);
      const Eigen::LDLT<MatrixXd> factor(gram);
      const MatrixXd toChosen = columns(chosen);  // candidates × chosen
      const MatrixXd projection = factor.solve(toChosen.transpose());
      residualCross -= projection.transpose() * cross;
      residualGram -= (toChosen.array() * projection.transpose().array()).rowwise().sum().matrix();
      error -= (cross.array() * factor.solve(cross).array()).sum();
    }
    const double floor = 1e-12 * gram_.diagonal().maxCoeff();
    Index bestCandidate = 0;
    double bestGain = -1.0;
    for (Index j = 0; j < candidateCount(); ++j) {
      if (residualGram[j] <= floor) continue;
      if (std::find(chosen.begin(), chosen.end(), j) != chosen.end()) continue;
      const double gain = residualCross.row(j).squaredNorm() / residualGram[j];
      if (gain > bestGain) {
        bestGain = gain;
        bestCandidate = j;
      }
    }
    errorLeft = error - bestGain;
    return bestGain < 0.0 ? Index{-1} : bestCandidate;
  }

 private:
  struct Part {
    MatrixXd gram, cross;
  };

  MatrixXd columns(const std::vector<Index>& chosen) const {
    MatrixXd picked(gram_.rows(), static_cast<Index>(chosen.size()));
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      picked.col(static_cast<Index>(k)) = gram_.col(chosen[k]);
    }
    return picked;
  }

  Part part(const std::vector<Index>& chosen) const {
    const auto n = static_cast<Index>(chosen.size());
    Part picked{MatrixXd(n, n), MatrixXd(n, cross_.cols())};
    for (Index i = 0; i < n; ++i) {
      picked.cross.row(i) = cross_.row(chosen[static_cast<std::size_t>(i)]);
      for (Index j = 0; j < n; ++j) {
        picked.gram(i, j) =
            gram_(chosen[static_cast<std::size_t>(i)], chosen[static_cast<std::size_t>(j)]);
      }
    }
    return picked;
  }

  MatrixXd gram_;
  MatrixXd cross_;
  double total_;
};

// Replaces each node by the best candidate for its place until a round changes nothing.
void exchange(const Selection& selection, std::vector<Index>& chosen) {
  constexpr int kRounds = 20;
  constexpr double kWorthwhile = 0.9999;
  double error = selection.squaredError(chosen);
  for (int round = 0; round < kRounds; ++round) {
    bool changed = false;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      std::vector<Index> others = chosen;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      double left = std::numeric_limits<double>::infinity();
      const Index candidate = selection.best(others, left);
      if (candidate < 0 || candidate == chosen[k] || left >= kWorthwhile * error) continue;
      chosen[k] = candidate;
      error = left;
      changed = true;
    }
    if (!changed) return;
  }
}

MatrixXd gather(const SpectrumRows& spectra, const std::vector<int>& samples) {
  MatrixXd picked(spectra.rows(), static_cast<Index>(samples.size()));
  for (std::size_t k = 0; k < samples.size(); ++k) {
    picked.col(static_cast<Index>(k)) = spectra.col(samples[k]).matrix();
  }
  return picked;
}

std::vector<int> samplesInUse(const SpectrumRows& rows) {
  std::vector<int> samples;
  for (int i = 0; i < kSampleCount; ++i) {
    if ((rows.col(i) != 0.0).any()) samples.push_back(i);
  }
  return samples;
}

SpectralNodes withWeights(const SpectrumRows& rows, const SpectrumRows& training,
                          const SpectrumRows& checking, std::vector<int> samples) {
  std::sort(samples.begin(), samples.end());
  SpectralNodes nodes;
  nodes.samples = std::move(samples);
  const MatrixXd target = training.matrix() * rows.matrix().transpose();
  nodes.weights = MatrixXd(rows.rows(), 0);
  if (!nodes.samples.empty()) {
    // Orthogonal factorisation: the normal equations would lose half the digits here.
    nodes.weights = gather(training, nodes.samples).colPivHouseholderQr().solve(target).transpose();
  }
  const MatrixXd error = gather(checking, nodes.samples) * nodes.weights.transpose() -
                         checking.matrix() * rows.matrix().transpose();
  nodes.rmsError = std::sqrt(error.squaredNorm() / static_cast<double>(error.size()));
  nodes.worstError = error.cwiseAbs().maxCoeff();
  return nodes;
}

}  // namespace

SpectralNodes chooseSpectralNodes(const SpectrumRows& rows, const SpectrumRows& training,
                                  const SpectrumRows& checking, const NodeOptions& options) {
  const std::vector<int> candidates = samplesInUse(rows);
  SpectralNodes nodes = withWeights(rows, training, checking, {});
  if (candidates.empty()) return nodes;
  const MatrixXd target = training.matrix() * rows.matrix().transpose();
  const Selection selection(gather(training, candidates), target);
  const auto toSamples = [&](const std::vector<Index>& chosen) {
    std::vector<int> samples;
    for (const Index j : chosen)
      samples.push_back(candidates[static_cast<std::size_t>(j)]);
    return samples;
  };

  std::vector<Index> chosen;
  const auto limit =
      std::min<std::size_t>(candidates.size(), static_cast<std::size_t>(options.maximumNodes));
  while (chosen.size() < limit) {
    double left = 0.0;
    const Index next = selection.best(chosen, left);
    if (next < 0) break;
    chosen.push_back(next);
    exchange(selection, chosen);
    nodes = withWeights(rows, training, checking, toSamples(chosen));
    if (nodes.rmsError <= options.rmsTolerance) break;
  }
  return nodes;
}

}  // namespace cutis
