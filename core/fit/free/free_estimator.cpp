#include "core/fit/free/free_estimator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/fit/deviation_limit.h"
#include "core/maths/decompositions.h"
#include "core/maths/weighted_sums.h"

namespace cutis {

template <int N>
FreeEstimator<N>::FreeEstimator(FreeProblem problem)
    : problem_(std::move(problem)),
      low_(Eigen::Matrix<double, N, 1>::Zero()),
      range_(Eigen::Matrix<double, N, 1>::Ones()) {
  const Eigen::MatrixXd& weights = problem_.channels->nodes().weights;
  for (Eigen::Index k = 0; k < weights.rows(); ++k) {
    if ((weights.row(k).array() == 0.0).all()) continue;
    channels_.push_back(static_cast<std::size_t>(k));
    for (Eigen::Index n = 0; n < weights.cols(); ++n)
      weights_.push_back(weights(k, n));
  }
  const CoordinatePrior& prior = problem_.parameters;
  low_.template head<kParameterCount>() = prior.low.matrix();
  range_.template head<kParameterCount>() = (prior.high - prior.low).matrix();
  mean_.template head<kParameterCount>() =
      ((prior.mean - prior.low) / (prior.high - prior.low)).matrix();
  const auto unit = range_.template head<kParameterCount>().asDiagonal();
  precision_.template topLeftCorner<kParameterCount, kParameterCount>() =
      unit * prior.precision * unit;
  const FreeCoordinates& coordinates = problem_.channels->skin().coordinates();
  coordinates.coordinatesOf(problem_.constants.mean, mean_.data() + kParameterCount);
  for (const SkinConstant constant : kSkinConstants) {
    if (!coordinates.free().has(constant)) continue;
    const int at = kParameterCount + coordinates.indexOf(constant);
    const double deviation =
        problem_.constants.deviation(constant, problem_.constants.mean[constant]) /
        coordinates.slope(constant, problem_.constants.mean);
    precision_(at, at) = 1.0 / (deviation * deviation);
  }
}

template <int N>
SkinConstants FreeEstimator<N>::constantsAt(const Point& point) const {
  return problem_.channels->skin().coordinates().constantsAt(point.data() + kParameterCount);
}

template <int N>
auto FreeEstimator<N>::pointOf(const double* values) const -> Point {
  Point point;
  for (int k = 0; k < kParameterCount; ++k) {
    point[k] = (problem_.parameters.coordinate(k, values[k]) - low_[k]) / range_[k];
    if (problem_.parameters.isFixed[static_cast<std::size_t>(k)]) point[k] = mean_[k];
  }
  const FreeCoordinates& coordinates = problem_.channels->skin().coordinates();
  SkinConstants constants = coordinates.own();
  for (const SkinConstant constant : kSkinConstants) {
    if (coordinates.free().has(constant)) {
      constants[constant] = values[kParameterCount + coordinates.indexOf(constant)];
    }
  }
  coordinates.coordinatesOf(constants, point.data() + kParameterCount);
  return point.cwiseMax(0.0).cwiseMin(1.0);
}

template <int N>
void FreeEstimator<N>::valuesOf(const Point& point, double* values) const {
  for (int k = 0; k < kParameterCount; ++k) {
    const double coordinate = low_[k] + range_[k] * point[k];
    values[k] =
        problem_.parameters.isLog[static_cast<std::size_t>(k)] ? std::exp(coordinate) : coordinate;
  }
  const FreeCoordinates& coordinates = problem_.channels->skin().coordinates();
  const SkinConstants constants = constantsAt(point);
  for (const SkinConstant constant : kSkinConstants) {
    if (coordinates.free().has(constant)) {
      values[kParameterCount + coordinates.indexOf(constant)] = constants[constant];
    }
  }
}

template <int N>
std::vector<double> FreeEstimator<N>::nodeValues(std::span<const Point> points) const {
  const std::size_t count = points.size();
  const FreeSkin& skin = problem_.channels->skin();
  const FreeCoordinates& coordinates = skin.coordinates();
  std::vector<ParameterVector> parameters(count);
  std::vector<SkinConstants> constants(count);
  std::vector<Point> units(count);  // of a value by its coordinate
  for (std::size_t i = 0; i < count; ++i) {
    double values[N];
    valuesOf(points[i], values);
    parameters[i] = Eigen::Map<const ParameterVector>(values);
    constants[i] = constantsAt(points[i]);
    for (int k = 0; k < kParameterCount; ++k) {
      const auto index = static_cast<std::size_t>(k);
      units[i][k] = problem_.parameters.isFixed[index] ? 0.0
                    : problem_.parameters.isLog[index] ? range_[k] * values[k]
                                                       : range_[k];
    }
    for (const SkinConstant constant : kSkinConstants) {
      if (!coordinates.free().has(constant)) continue;
      units[i][kParameterCount + coordinates.indexOf(constant)] =
          coordinates.slope(constant, constants[i]);
    }
  }
  const FreeSpectra spectra = skin.evaluate(parameters, constants, true);
  std::vector<double> nodes(skin.samples().size() * (N + 1) * count);
  for (std::size_t s = 0; s < skin.samples().size(); ++s) {
    double* out = nodes.data() + s * (N + 1) * count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = s * count + i;
      const auto put = [&](int k, double slope) {
        out[static_cast<std::size_t>(1 + k) * count + i] = slope * units[i][k];
      };
      out[i] = spectra.reflectance[at];
      ParameterVector slopes;
      skin.byParameters(spectra, s, i, count, parameters[i], slopes);
      for (int k = 0; k < kParameterCount; ++k)
        put(k, slopes[k]);
      if (coordinates.free().oxygenation) put(kParameterCount, spectra.perOxygenation[at]);
      if (coordinates.free().thickness) put(N - 1, spectra.perThickness[at]);
    }
  }
  return nodes;
}

template <int N>
void FreeEstimator<N>::addPrior(const Point& point, EquationsOf<N>& equations) const {
  const Point away = mean_ - point;
  const Point pull = precision_ * away;
  equations.hessian += precision_;
  equations.downhill += pull;
  equations.cost += away.dot(pull);
}

template <int N>
auto FreeEstimator<N>::linearise(std::span<const Point> points, std::span<const std::size_t> pixels,
                                 PixelRows<const float> channels) const -> std::vector<Linearised> {
  const std::size_t count = points.size();
  const std::vector<double> nodes = nodeValues(points);
  const std::size_t width = (N + 1) * count;
  // The channels and their derivatives: [channel][1 + N][point].
  std::vector<double> modelled(channels_.size() * width);
  runWeightedSums({weights_.data(), channels_.size(), weights_.size() / channels_.size(),
                   nodes.data(), width, modelled.data()});
  EquationSums<N> sums(count);
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const double* row = modelled.data() + c * width;
    const float* measured = channels.row(channels_[c]);
    for (std::size_t i = 0; i < count; ++i) {
      const double value = double{measured[pixels[i]]};
      const double root = 1.0 / std::sqrt(problem_.noise.variance(value));
      sums.residual()[i] = root * (value - row[i]);
      for (std::size_t k = 0; k < N; ++k)
        sums.gradient(k)[i] = root * row[(1 + k) * count + i];
    }
    sums.add();
  }
  const std::vector<EquationsOf<N>> equations = sums.equations();
  std::vector<Linearised> linearised(count);
  for (std::size_t i = 0; i < count; ++i) {
    linearised[i] = {equations[i], equations[i].cost};
    addPrior(points[i], linearised[i].equations);
  }
  return linearised;
}

template <int N>
void FreeEstimator<N>::deviationsAt(const Point& point, const EquationsOf<N>& equations,
                                    double* deviations) const {
  const Eigen::Matrix<double, N, N> covariance = inverseOfPositive<N>(equations.hessian);
  double values[N];
  valuesOf(point, values);
  const FreeCoordinates& coordinates = problem_.channels->skin().coordinates();
  const SkinConstants constants = constantsAt(point);
  for (int k = 0; k < kParameterCount; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const double unit = problem_.parameters.isLog[index] ? range_[k] * values[k] : range_[k];
    const double high = problem_.parameters.high[k];
    const double maximum = problem_.parameters.isLog[index] ? std::exp(high) : high;
    const double deviation = unit * std::sqrt(std::max(0.0, covariance(k, k)));
    deviations[k] =
        problem_.parameters.isFixed[index] ? 0.0 : limitedDeviation(deviation, values[k], maximum);
  }
  for (const SkinConstant constant : kSkinConstants) {
    if (!coordinates.free().has(constant)) continue;
    const int k = kParameterCount + coordinates.indexOf(constant);
    deviations[k] =
        coordinates.slope(constant, constants) * std::sqrt(std::max(0.0, covariance(k, k)));
  }
}

template <int N>
double FreeEstimator<N>::mostChannelCost() const {
  const auto channels = static_cast<double>(channels_.size());
  return channels + 4.0 * std::sqrt(2.0 * channels);
}

template class FreeEstimator<kParameterCount + 1>;
template class FreeEstimator<kParameterCount + 2>;

}  // namespace cutis
