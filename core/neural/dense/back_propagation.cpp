#include "core/neural/dense/back_propagation.h"

#include <algorithm>
#include <cassert>

#include "core/neural/dense/dense_kernel.h"

namespace cutis {
namespace {

std::vector<float> transposedWeights(const DenseLayer& layer) {
  const auto inputs = static_cast<std::size_t>(layer.inputs);
  const auto outputs = static_cast<std::size_t>(layer.outputs);
  std::vector<float> result(layer.weights.size());
  for (std::size_t o = 0; o < outputs; ++o) {
    for (std::size_t i = 0; i < inputs; ++i) {
      result[i * outputs + o] = layer.weights[o * inputs + i];
    }
  }
  return result;
}

}  // namespace

BackPropagation::BackPropagation(const DenseNetwork& network,
                                 const std::vector<float>& targetWeights, TrainedLayers trained)
    : network_(network), targetWeights_(targetWeights), trained_(trained) {
  assert(targetWeights.size() == static_cast<std::size_t>(network.outputs()));
  const std::size_t layerCount = network.layers.size();
  trained_.last = std::min(trained_.last, layerCount);
  transposed_.resize(layerCount);
  int widest = 0;
  for (std::size_t i = trained_.first; i < layerCount; ++i) {
    const DenseLayer& layer = network.layers[i];
    if (i < trained_.last) gradientSize_ += layer.weights.size() + layer.bias.size();
    if (i > trained_.first) transposed_[i] = transposedWeights(layer);
    widest = std::max(widest, layer.inputs);
  }
  noBias_.resize(static_cast<std::size_t>(widest), 0.0f);
}

void BackPropagation::forward(const SamplePiece& piece, PropagationScratch& scratch) const {
  scratch.outputs.resize(network_.layers.size());
  const float* in = piece.inputs.data;
  for (std::size_t i = 0; i < network_.layers.size(); ++i) {
    const DenseKernelLayer layer = kernelLayer(network_.layers[i]);
    scratch.outputs[i].resize(layer.outputs * piece.inputs.stride);
    forwardLayer(layer, in, scratch.outputs[i].data(), piece.inputs.stride);
    in = scratch.outputs[i].data();
  }
}

double BackPropagation::compare(const SamplePiece& piece, PropagationScratch& scratch) const {
  const AlignedFloats& outputs = scratch.outputs.back();
  scratch.gradient.assign(outputs.size(), 0.0f);
  double error = 0.0;
  for (std::size_t o = 0; o < targetWeights_.size(); ++o) {
    const float weight = targetWeights_[o];
    const float* target = piece.targets.row(o);
    for (std::size_t n = 0; n < piece.targets.count; ++n) {
      const std::size_t i = o * piece.inputs.stride + n;
      const float difference = outputs[i] - target[n];
      scratch.gradient[i] = 2.0f * weight * difference;
      error += static_cast<double>(weight * difference * difference);
    }
  }
  return error;
}

double BackPropagation::error(const SamplePiece& piece, PropagationScratch& scratch) const {
  forward(piece, scratch);
  return compare(piece, scratch);
}

double BackPropagation::addGradient(const SamplePiece& piece, PropagationScratch& scratch,
                                    float* gradient) const {
  const double pieceError = error(piece, scratch);
  float* end = gradient + gradientSize_;  // of the gradient by the layers still to come
  for (std::size_t i = network_.layers.size(); i-- > trained_.first;) {
    const DenseKernelLayer layer = kernelLayer(network_.layers[i]);
    throughActivation(layer.activation, scratch.outputs[i].data(), scratch.gradient.data(),
                      layer.outputs * piece.inputs.stride);
    if (i < trained_.last) {
      const float* in = i > 0 ? scratch.outputs[i - 1].data() : piece.inputs.data;
      float* biasGradient = end - layer.outputs;
      end = biasGradient - layer.inputs * layer.outputs;
      addWeightGradient(scratch.gradient.data(), layer.outputs, in, layer.inputs,
                        piece.inputs.stride, end, biasGradient);
    }
    if (i == trained_.first) break;
    scratch.gradientBelow.resize(layer.inputs * piece.inputs.stride);
    const DenseKernelLayer back = {transposed_[i].data(), noBias_.data(), layer.outputs,
                                   layer.inputs, Activation::linear};
    forwardLayer(back, scratch.gradient.data(), scratch.gradientBelow.data(), piece.inputs.stride);
    std::swap(scratch.gradient, scratch.gradientBelow);
  }
  return pieceError;
}

}  // namespace cutis
