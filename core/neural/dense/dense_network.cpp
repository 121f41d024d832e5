#include "core/neural/dense/dense_network.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/random.h"

namespace cutis {
namespace {

using Eigen::Index;
using RowMajorFloat = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const RowMajorFloat> weightsOf(const DenseLayer& layer) {
  return {layer.weights.data(), layer.outputs, layer.inputs};
}

Eigen::Map<const Eigen::VectorXf> biasOf(const DenseLayer& layer) {
  return {layer.bias.data(), layer.outputs};
}

template <typename T>
T activated(Activation activation, T x) {
  switch (activation) {
    case Activation::relu:
      return std::max(x, T(0));
    case Activation::sigmoid:
      return T(1) / (T(1) + std::exp(-std::clamp(x, T(-36), T(36))));
    case Activation::squareplus:
      return T(0.5) * (x + std::sqrt(x * x + T(1)));
    case Activation::linear:
      break;
  }
  return x;
}

// Far beyond what training leads to: what is larger is damaged, and its products overflow.
constexpr float kLargestWeight = 1e7f;

bool allSound(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](float v) { return std::abs(v) <= kLargestWeight; });
}

std::string layerName(std::size_t index) {
  return "layer " + std::to_string(index + 1);
}

Status validateLayer(const DenseLayer& layer, std::size_t index, const std::string& place) {
  const auto sized = [](int units) { return units >= 1 && units <= kMaximumUnits; };
  if (!sized(layer.inputs) || !sized(layer.outputs)) {
    return inputError(place, layerName(index) + " must have 1 to " + std::to_string(kMaximumUnits) +
                                 " inputs and outputs");
  }
  const auto inputs = static_cast<std::size_t>(layer.inputs);
  const auto outputs = static_cast<std::size_t>(layer.outputs);
  if (layer.weights.size() != inputs * outputs || layer.bias.size() != outputs) {
    return inputError(place, layerName(index) + " needs " + std::to_string(inputs * outputs) +
                                 " weights and " + std::to_string(outputs) + " biases, not " +
                                 std::to_string(layer.weights.size()) + " and " +
                                 std::to_string(layer.bias.size()));
  }
  if (!allSound(layer.weights) || !allSound(layer.bias)) {
    return inputError(place, layerName(index) +
                                 " has a weight that is not a finite number below 1e7; train the "
                                 "network again");
  }
  return {};
}

}  // namespace

DenseKernelLayer kernelLayer(const DenseLayer& layer) {
  return {layer.weights.data(), layer.bias.data(), static_cast<std::size_t>(layer.inputs),
          static_cast<std::size_t>(layer.outputs), layer.activation};
}

std::size_t DenseNetwork::parameterCount() const {
  std::size_t count = 0;
  for (const DenseLayer& layer : layers)
    count += layer.weights.size() + layer.bias.size();
  return count;
}

std::size_t DenseNetwork::workPerSample() const {
  std::size_t work = 0;
  for (const DenseLayer& layer : layers)
    work += layer.weights.size();
  return work;
}

Status validate(const DenseNetwork& network, const std::string& place) {
  if (network.layers.empty() || network.layers.size() > std::size_t{kMaximumLayers}) {
    return inputError(place, "a network has 1 to " + std::to_string(kMaximumLayers) +
                                 " layers, not " + std::to_string(network.layers.size()));
  }
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    CUTIS_CHECK(validateLayer(network.layers[i], i, place));
    if (i > 0 && network.layers[i].inputs != network.layers[i - 1].outputs) {
      return inputError(place, layerName(i) + " has " + std::to_string(network.layers[i].inputs) +
                                   " inputs, but the layer before it has " +
                                   std::to_string(network.layers[i - 1].outputs) + " outputs");
    }
  }
  return {};
}

bool sameShape(const DenseNetwork& a, const DenseNetwork& b) {
  return std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(),
                    [](const DenseLayer& x, const DenseLayer& y) {
                      return x.inputs == y.inputs && x.outputs == y.outputs &&
                             x.activation == y.activation;
                    });
}

DenseNetwork randomNetwork(const std::vector<int>& sizes, Activation hidden, Activation last,
                           std::uint64_t seed) {
  assert(sizes.size() >= 2);
  Random random(seed);
  DenseNetwork network;
  for (std::size_t i = 0; i + 1 < sizes.size(); ++i) {
    const bool isLast = i + 2 == sizes.size();
    DenseLayer layer;
    layer.inputs = sizes[i];
    layer.outputs = sizes[i + 1];
    layer.activation = isLast ? last : hidden;
    const double deviation = std::sqrt((isLast ? 0.5 : 2.0) / layer.inputs);
    for (int k = 0; k < layer.inputs * layer.outputs; ++k) {
      layer.weights.push_back(static_cast<float>(deviation * random.normal()));
    }
    for (int k = 0; k < layer.outputs; ++k) {
      layer.bias.push_back(static_cast<float>(0.1 * random.normal()));
    }
    network.layers.push_back(std::move(layer));
  }
  return network;
}

DenseLayer linearLayer(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& offset) {
  assert(matrix.rows() == offset.size());
  DenseLayer layer;
  layer.inputs = static_cast<int>(matrix.cols());
  layer.outputs = static_cast<int>(matrix.rows());
  layer.weights.resize(static_cast<std::size_t>(matrix.size()));
  layer.bias.resize(static_cast<std::size_t>(offset.size()));
  Eigen::Map<RowMajorFloat>(layer.weights.data(), matrix.rows(), matrix.cols()) =
      matrix.cast<float>();
  Eigen::Map<Eigen::VectorXf>(layer.bias.data(), offset.size()) = offset.cast<float>();
  return layer;
}

DenseNetwork joined(const DenseNetwork& first, const DenseNetwork& second) {
  assert(first.outputs() == second.inputs());
  DenseNetwork network = first;
  network.layers.insert(network.layers.end(), second.layers.begin(), second.layers.end());
  return network;
}

DenseNetwork merged(const DenseNetwork& network) {
  DenseNetwork result;
  Eigen::MatrixXd matrix;  // of linear layers so far
  Eigen::VectorXd offset;
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    const DenseLayer& layer = network.layers[i];
    const Eigen::MatrixXd weights = weightsOf(layer).cast<double>();
    const Eigen::VectorXd bias = biasOf(layer).cast<double>();
    const bool follows = matrix.size() > 0;
    offset = follows ? Eigen::VectorXd(weights * offset + bias) : bias;
    matrix = follows ? Eigen::MatrixXd(weights * matrix) : weights;
    if (layer.activation == Activation::linear && i + 1 < network.layers.size()) continue;
    result.layers.push_back(linearLayer(matrix, offset));
    result.layers.back().activation = layer.activation;
    matrix.resize(0, 0);
  }
  return result;
}

template <typename T>
SampleMatrix<T> evaluate(const DenseNetwork& network, const SampleMatrix<T>& samples) {
  SampleMatrix<T> values = samples;
  for (const DenseLayer& layer : network.layers) {
    const SampleMatrix<T> weights = weightsOf(layer).template cast<T>();
    const Eigen::Matrix<T, Eigen::Dynamic, 1> bias = biasOf(layer).template cast<T>();
    const SampleMatrix<T> sums = (weights * values).colwise() + bias;
    values = sums.unaryExpr([&](T x) { return activated(layer.activation, x); });
  }
  return values;
}

template SampleMatrix<float> evaluate(const DenseNetwork&, const SampleMatrix<float>&);
template SampleMatrix<double> evaluate(const DenseNetwork&, const SampleMatrix<double>&);

}  // namespace cutis
