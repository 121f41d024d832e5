#include "core/skin/layers/polynomial_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Dense>

namespace cutis {
namespace {

constexpr int kEpidermalSamples = 20;
constexpr int kDermalSamples = 11;
constexpr double kMargin = 0.02;
constexpr double kSmallestWidth = 1.05;  // high over low
constexpr double kSmallestAbsorption = 1e-4;
// The knee of the axis along which adding–doubling is sampled, and those tried for the polynomial;
// in units of the root of the layer's scattering.
constexpr double kSampledKnee = 0.6;
constexpr double kKnees[] = {0.2, 0.3, 0.45, 0.7, 1.0, 1.4, 2.0, 3.0};

AbsorptionRange widened(const AbsorptionRange& range) {
  const double low = std::max((1.0 - kMargin) * range.low, kSmallestAbsorption);
  return {low, std::max((1.0 + kMargin) * range.high, kSmallestWidth * low)};
}

AbsorptionScale<double> scaleFor(const AbsorptionRange& range, double knee) {
  const double first = 1.0 / (std::sqrt(range.low) + knee);
  const double last = 1.0 / (std::sqrt(range.high) + knee);
  const double span = 2.0 / (first - last);
  return {range.low, range.high, knee, span, 1.0 + span * last};
}

double positionOf(const AbsorptionScale<double>& layer, double absorption) {
  return layer.end - layer.span / (std::sqrt(absorption) + layer.knee);
}

double absorptionAt(const AbsorptionScale<double>& layer, double position) {
  const double root = layer.span / (layer.end - position) - layer.knee;
  return std::clamp(root * root, layer.low, layer.high);
}

std::vector<double> sampledAbsorptions(const AbsorptionRange& range, double scattering, int count) {
  const AbsorptionScale<double> layer = scaleFor(range, kSampledKnee * std::sqrt(scattering));
  std::vector<double> absorptions;
  for (int i = 0; i < count; ++i) {
    absorptions.push_back(absorptionAt(layer, -std::cos(std::numbers::pi * (i + 0.5) / count)));
  }
  return absorptions;
}

// Chebyshev polynomials T_0 … at the positions of the absorptions.
Eigen::MatrixXd chebyshevBasis(const AbsorptionScale<double>& layer,
                               const std::vector<double>& absorptions, int terms) {
  Eigen::MatrixXd basis(static_cast<Eigen::Index>(absorptions.size()), terms);
  for (Eigen::Index i = 0; i < basis.rows(); ++i) {
    const double z = positionOf(layer, absorptions[static_cast<std::size_t>(i)]);
    basis(i, 0) = 1.0;
    basis(i, 1) = z;
    for (int k = 2; k < terms; ++k)
      basis(i, k) = 2.0 * z * basis(i, k - 1) - basis(i, k - 2);
  }
  return basis;
}

// Column k: the powers of z in T_k.
Eigen::MatrixXd powersOfChebyshev(int terms) {
  Eigen::MatrixXd powers = Eigen::MatrixXd::Zero(terms, terms);
  powers(0, 0) = powers(1, 1) = 1.0;
  for (int k = 2; k < terms; ++k) {
    powers.col(k).tail(terms - 1) = 2.0 * powers.col(k - 1).head(terms - 1);
    powers.col(k) -= powers.col(k - 2);
  }
  return powers;
}

// One axis: the scale whose polynomials come closest to the columns of `values`, and the matrix
// that turns values into powers of z.
struct AxisFit {
  AbsorptionScale<double> scale = {};
  Eigen::MatrixXd powers;
};

Result<AxisFit> fitAxis(const AbsorptionRange& range, double scattering,
                        const std::vector<double>& absorptions, int terms,
                        const Eigen::MatrixXd& values) {
  AxisFit best = {};
  double smallest = std::numeric_limits<double>::infinity();
  const auto count = static_cast<Eigen::Index>(absorptions.size());
  for (const double knee : kKnees) {
    const AbsorptionScale<double> scale = scaleFor(range, knee * std::sqrt(scattering));
    const Eigen::MatrixXd basis = chebyshevBasis(scale, absorptions, terms);
    const Eigen::MatrixXd solve =
        basis.householderQr().solve(Eigen::MatrixXd::Identity(count, count));
    const double residual = (values - basis * (solve * values)).cwiseAbs().maxCoeff();
    if (residual < smallest) {
      smallest = residual;
      best = {scale, powersOfChebyshev(terms) * solve};
    }
  }
  if (best.powers.size() == 0) {
    return inputError("",
                      "no reflectance can be computed for these layers; correct their constants");
  }
  return best;
}

bool isRange(const AbsorptionRange& range) {
  return range.low >= 0.0 && range.low <= range.high && std::isfinite(range.high);
}

AbsorptionScale<float> singleScale(const AbsorptionScale<double>& layer) {
  return {static_cast<float>(layer.low), static_cast<float>(layer.high),
          static_cast<float>(layer.knee), static_cast<float>(layer.span),
          static_cast<float>(layer.end)};
}

// z and dz/dσ_a.
struct Position {
  double value, slope;
};

Position positionWithSlope(const AbsorptionScale<double>& layer, double absorption) {
  const double root = std::sqrt(std::clamp(absorption, layer.low, layer.high));
  const double sum = root + layer.knee;
  return {layer.end - layer.span / sum, layer.span / (2.0 * root * sum * sum)};
}

}  // namespace

Result<LayerPolynomial<double>> fitLayerPolynomial(const TwoLayers& layers,
                                                   const TransportOptions& options) {
  if (!isRange(layers.epidermalRange) || !isRange(layers.dermalRange)) {
    return inputError("", "a range of absorption must be finite, not negative and not reversed");
  }
  if (!(layers.epidermalScattering > 0.0 && layers.dermalScattering > 0.0)) {
    return inputError("", "scattering must be positive in both layers");
  }
  const AbsorptionRange epidermal = widened(layers.epidermalRange);
  const AbsorptionRange dermal = widened(layers.dermalRange);
  const auto epidermalSamples =
      sampledAbsorptions(epidermal, layers.epidermalScattering, kEpidermalSamples);
  const auto dermalSamples = sampledAbsorptions(dermal, layers.dermalScattering, kDermalSamples);
  CUTIS_TRY(sampled,
            twoLayerReflectances({layers.thickness, layers.epidermalScattering,
                                  layers.dermalScattering, epidermalSamples, dermalSamples},
                                 options));
  const Eigen::MatrixXd values = sampled.matrix();
  CUTIS_TRY(rows, fitAxis(epidermal, layers.epidermalScattering, epidermalSamples, kEpidermalTerms,
                          values));
  CUTIS_TRY(columns, fitAxis(dermal, layers.dermalScattering, dermalSamples, kDermalTerms,
                             values.transpose()));
  const Eigen::MatrixXd powers = rows.powers * values * columns.powers.transpose();
  LayerPolynomial<double> polynomial;
  polynomial.epidermis = rows.scale;
  polynomial.dermis = columns.scale;
  for (int i = 0; i < kEpidermalTerms; ++i) {
    for (int j = 0; j < kDermalTerms; ++j)
      polynomial.coefficients[i][j] = powers(i, j);
  }
  return polynomial;
}

LayerPolynomial<float> singlePrecision(const LayerPolynomial<double>& polynomial) {
  LayerPolynomial<float> rounded;
  rounded.epidermis = singleScale(polynomial.epidermis);
  rounded.dermis = singleScale(polynomial.dermis);
  for (int i = 0; i < kEpidermalTerms; ++i) {
    for (int j = 0; j < kDermalTerms; ++j) {
      rounded.coefficients[i][j] = static_cast<float>(polynomial.coefficients[i][j]);
    }
  }
  return rounded;
}

LayeredReflectance evaluate(const LayerPolynomial<double>& polynomial, double epidermalAbsorption,
                            double dermalAbsorption) {
  const Position z = positionWithSlope(polynomial.epidermis, epidermalAbsorption);
  const Position y = positionWithSlope(polynomial.dermis, dermalAbsorption);
  double value = 0.0, perZ = 0.0, perY = 0.0;
  for (int i = kEpidermalTerms - 1; i >= 0; --i) {
    double row = 0.0, rowPerY = 0.0;
    for (int j = kDermalTerms - 1; j >= 0; --j) {
      rowPerY = rowPerY * y.value + row;
      row = row * y.value + polynomial.coefficients[i][j];
    }
    perZ = perZ * z.value + value;
    value = value * z.value + row;
    perY = perY * z.value + rowPerY;
  }
  return {value, perZ * z.slope, perY * y.slope};
}

}  // namespace cutis
