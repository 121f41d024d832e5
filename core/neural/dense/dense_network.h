#pragma once  // internal to core/neural/dense

// A fully connected network as plain data: layers of units, each a weighted sum through an
// activation. Scalings of inputs and outputs, whitening, and the way from PCA weights to channels
// are linear layers like any other; merged() folds them into their neighbours before anything is
// evaluated often.
//
// The functions here are the plain reference; pictures go through core/neural/network_pipeline.h.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/neural/dense/activation.h"
#include "core/neural/dense/dense_kernel.h"

namespace cutis {

inline constexpr int kMaximumLayers = 16;
inline constexpr int kMaximumUnits = 512;

struct DenseLayer {
  int inputs = 0;
  int outputs = 0;
  Activation activation = Activation::linear;
  std::vector<float> weights;  // [output][input]
  std::vector<float> bias;     // [output]

  bool operator==(const DenseLayer&) const = default;
};

// As kernels read it. The layer outlives the result and keeps its arrays.
DenseKernelLayer kernelLayer(const DenseLayer& layer);

struct DenseNetwork {
  std::vector<DenseLayer> layers;

  // Precondition: there are layers.
  int inputs() const { return layers.front().inputs; }
  int outputs() const { return layers.back().outputs; }
  // Weights and biases.
  std::size_t parameterCount() const;
  // Multiply-adds of one evaluation.
  std::size_t workPerSample() const;

  bool operator==(const DenseNetwork&) const = default;
};

// Checks that there are layers and not too many, 1 to kMaximumUnits inputs and outputs each, that
// they fit together and into their arrays, and that all numbers are finite. `place` names the
// source in the error.
Status validate(const DenseNetwork& network, const std::string& place);

// Whether the layers of both have the same sizes and activations.
bool sameShape(const DenseNetwork& a, const DenseNetwork& b);

// Sizes from the inputs to the outputs, at least two. Weights normal with variance 2 / inputs (1/4
// of it in the last layer), biases normal with deviation 0.1. Deterministic by seed.
DenseNetwork randomNetwork(const std::vector<int>& sizes, Activation hidden, Activation last,
                           std::uint64_t seed);

// out = matrix · in + offset. Rounded to float.
DenseLayer linearLayer(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& offset);

// One after the other. Precondition: the outputs of the first are the inputs of the second.
DenseNetwork joined(const DenseNetwork& first, const DenseNetwork& second);

// The same function with every linear layer folded into the one after it, in double precision.
DenseNetwork merged(const DenseNetwork& network);

// One sample a column. T is float or double. NaN in a sample stays in it, save where a relu's
// maximum drops it.
template <typename T>
using SampleMatrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
template <typename T>
SampleMatrix<T> evaluate(const DenseNetwork& network, const SampleMatrix<T>& samples);

}  // namespace cutis
