#include "core/fit/refined/start_polynomial.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/fit/coordinate_prior.h"
#include "core/fit/population.h"
#include "core/maths/decompositions.h"
#include "core/skin/model/reflectance_batch.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kPixels = 12000;
constexpr std::uint64_t kSeed = 31;
// Share of the people that is drawn with larger deviations, and how much larger.
constexpr double kWideShare = 0.15;
constexpr double kWiderBy = 1.5;
// Components up to here on the other side count for a piece, too, so that the two nearly meet.
constexpr double kOverlap = 0.3;
constexpr double kSmallestChannel = 1e-4;
constexpr double kDarkestShade = 0.05;
// A component is limited to this many of its standard deviations (start_polynomial-inl.h).
constexpr double kLimit = 4.0;

static_assert(3 * kMaximumLights <= static_cast<int>(kMaximumFitChannels));

// People of the prior, with parameters that are held at their value.
std::vector<ParameterVector> drawPixels(const StartScene& scene) {
  const ParameterAxes& axes = scene.model.profile().axes;
  constexpr auto wideCount = static_cast<int>(kWideShare * kPixels);
  std::vector<ParameterVector> pixels =
      drawFromPrior(scene.prior, axes, kPixels - wideCount, kSeed);
  Prior wide = scene.prior;
  wide.deviation *= kWiderBy;
  const auto rest = drawFromPrior(wide, axes, wideCount, kSeed + 1);
  pixels.insert(pixels.end(), rest.begin(), rest.end());
  for (ParameterVector& p : pixels) {
    for (int i = 0; i < kParameterCount; ++i) {
      p[i] = scene.fixed[static_cast<std::size_t>(i)].value_or(p[i]);
    }
  }
  return pixels;
}

MatrixXd coordinatesOf(const std::vector<ParameterVector>& pixels, const CoordinatePrior& prior) {
  MatrixXd coordinates(static_cast<Index>(pixels.size()), kParameterCount);
  for (Index i = 0; i < coordinates.rows(); ++i) {
    for (int k = 0; k < kParameterCount; ++k) {
      coordinates(i, k) = prior.coordinate(k, pixels[static_cast<std::size_t>(i)][k]);
    }
  }
  return coordinates;
}

// What the model leaves over of each person, drawn.
void addDiscrepancy(const StartScene& scene, const std::vector<ParameterVector>& pixels,
                    MatrixXd& channels) {
  const ChannelDiscrepancy& seen = scene.discrepancy;
  const MatrixXd coordinates =
      coordinatesOf(pixels, coordinatePrior(scene.prior, scene.model.profile().axes, scene.fixed));
  const MatrixXd spread = seen.perCoefficient * rootOfPositive(seen.coefficientCovariance);
  Random random(kSeed, 3);
  for (Index i = 0; i < kPixels; ++i) {
    VectorXd drawn(spread.cols());
    for (double& value : drawn)
      value = random.normal();
    const VectorXd relative =
        seen.offset + seen.slope * coordinates.row(i).transpose() + spread * drawn;
    channels.row(i).array() *= 1.0 + relative.transpose().array();
  }
}

// Logarithms of noisy channels, one pixel a row.
MatrixXd simulateLogChannels(const StartScene& scene, const std::vector<ParameterVector>& pixels) {
  const CompiledModel compiled(scene.model, scene.nodes.samples);
  const PixelBuffer<double> parameters = parameterRows<double>(pixels);
  MatrixXd reflectance(kPixels, static_cast<Index>(scene.nodes.samples.size()));
  reflectanceBatch<double>(
      compiled, parameters.rows(),
      packedRows(reflectance.data(), scene.nodes.samples.size(), pixels.size()));
  const Index channelCount =
      scene.discrepancy.empty() ? scene.nodes.weights.rows() : scene.discrepancy.offset.size();
  MatrixXd channels = reflectance * scene.nodes.weights.topRows(channelCount).transpose();
  if (!scene.discrepancy.empty()) addDiscrepancy(scene, pixels, channels);
  if (scene.shadingDeviation > 0.0) {
    Random shades(kSeed, 2);
    for (Index i = 0; i < kPixels; ++i) {
      channels.row(i) *= std::max(1.0 + scene.shadingDeviation * shades.normal(), kDarkestShade);
    }
  }
  Random random(kSeed, 1);
  for (Index k = 0; k < channels.cols(); ++k) {
    for (Index i = 0; i < kPixels; ++i) {
      const double y = channels(i, k);
      const double deviation = std::sqrt(scene.noise.variance(y));
      channels(i, k) = std::log(std::max(y + deviation * random.normal(), kSmallestChannel));
    }
  }
  return channels;
}

// Products of up to four components, in the order in which the kernel adds them.
VectorXd startTerms(const VectorXd& component) {
  VectorXd terms(kStartTerms);
  Index t = 0;
  terms[t++] = 1.0;
  for (Index a = 0; a < kStartComponents; ++a) {
    terms[t++] = component[a];
    for (Index b = a; b < kStartComponents; ++b) {
      const double square = component[a] * component[b];
      terms[t++] = square;
      for (Index c = b; c < kStartComponents; ++c) {
        const double cube = square * component[c];
        terms[t++] = cube;
        for (Index e = c; e < kStartComponents; ++e)
          terms[t++] = cube * component[e];
      }
    }
  }
  return terms;
}

// Leading principal components, scaled to unit variance. Rows beyond the number of channels, and
// directions without variance, stay zero.
void fitProjection(const MatrixXd& logChannels, StartPolynomial& polynomial) {
  const Eigen::RowVectorXd mean = logChannels.colwise().mean();
  const MatrixXd centred = logChannels.rowwise() - mean;
  const SymmetricEigen eigen =
      symmetricEigen(centred.transpose() * centred / static_cast<double>(kPixels));
  const Index channelCount = logChannels.cols();
  for (Index c = 0; c < std::min<Index>(kStartComponents, channelCount); ++c) {
    const Index column = channelCount - 1 - c;  // eigenvalues increase
    const double variance = eigen.values[column];
    if (variance < 1e-12) continue;
    const VectorXd direction = eigen.vectors.col(column) / std::sqrt(variance);
    for (Index k = 0; k < channelCount; ++k) {
      polynomial.projection[c][k] = static_cast<float>(direction[k]);
    }
    polynomial.offset[c] = static_cast<float>(-mean.dot(direction));
  }
}

VectorXd componentsOf(const StartPolynomial& polynomial, const Eigen::RowVectorXd& logChannels) {
  VectorXd component(kStartComponents);
  for (Index c = 0; c < kStartComponents; ++c) {
    component[c] = double{polynomial.offset[c]};
    for (Index k = 0; k < logChannels.size(); ++k) {
      component[c] += double{polynomial.projection[c][k]} * logChannels[k];
    }
    component[c] = std::clamp(component[c], -kLimit, kLimit);
  }
  return component;
}

// Whether a pixel counts for a piece.
bool belongs(const VectorXd& component, int piece) {
  return piece == 0 ? component[0] < kOverlap : component[0] > -kOverlap;
}

// Coefficients by least squares. targets: coordinates, one pixel a row.
void fitCoefficients(const MatrixXd& logChannels, const MatrixXd& targets,
                     StartPolynomial& polynomial) {
  std::array<MatrixXd, kStartPieces> grams, crosses;
  grams.fill(MatrixXd::Zero(kStartTerms, kStartTerms));
  crosses.fill(MatrixXd::Zero(kStartTerms, kParameterCount));
  for (Index i = 0; i < logChannels.rows(); ++i) {
    const VectorXd component = componentsOf(polynomial, logChannels.row(i));
    const VectorXd terms = startTerms(component);
    for (int piece = 0; piece < kStartPieces; ++piece) {
      if (!belongs(component, piece)) continue;
      const auto p = static_cast<std::size_t>(piece);
      grams[p].selfadjointView<Eigen::Lower>().rankUpdate(terms);
      crosses[p] += terms * targets.row(i);
    }
  }
  for (int piece = 0; piece < kStartPieces; ++piece) {
    const auto p = static_cast<std::size_t>(piece);
    // A little ridge: with three channels one component is empty and its terms are zero.
    grams[p].diagonal().array() += 1e-6 * static_cast<double>(logChannels.rows());
    const MatrixXd solution = solvePositive(grams[p], crosses[p]);
    for (int k = 0; k < kParameterCount; ++k) {
      for (Index t = 0; t < kStartTerms; ++t) {
        polynomial.coefficients[piece][k][t] = static_cast<float>(solution(t, k));
      }
    }
  }
}

MatrixXd estimatesFrom(const StartPolynomial& start, const MatrixXd& logChannels,
                       const StartTrial& solve) {
  // Column by column, as Eigen stores them, is what the solver wants.
  const Eigen::MatrixXf channels = logChannels.array().exp().matrix().cast<float>();
  Eigen::MatrixXf coordinates(channels.rows(), kParameterCount);
  const auto count = static_cast<std::size_t>(channels.rows());
  solve(start, packedRows(channels.data(), static_cast<std::size_t>(channels.cols()), count),
        packedRows(coordinates.data(), kParameterCount, count));
  return coordinates.cast<double>();
}

}  // namespace

StartPolynomial trainStartPolynomial(const StartScene& scene, const StartTrial& solve) {
  const ParameterAxes& axes = scene.model.profile().axes;
  const std::vector<ParameterVector> pixels = drawPixels(scene);
  const MatrixXd logChannels = simulateLogChannels(scene, pixels);
  StartPolynomial polynomial = {};
  fitProjection(logChannels, polynomial);
  fitCoefficients(logChannels,
                  coordinatesOf(pixels, coordinatePrior(scene.prior, axes, scene.fixed)),
                  polynomial);
  fitCoefficients(logChannels, estimatesFrom(polynomial, logChannels, solve), polynomial);
  return polynomial;
}

}  // namespace cutis
