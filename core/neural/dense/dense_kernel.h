#pragma once

// Vectorised layers of a network, forwards and backwards: what training is made of, and the inner
// part of core/neural/network_kernel.cpp. Plain data.
//
// Arrays of samples are [unit][stride] with one sample a lane and a stride that is a multiple of
// kSampleStep. Sums run over units, or over samples, in an order that does not depend on threads;
// on one instruction set the results are always the same. Thread-safe.

#include <cstddef>

#include "core/neural/dense/activation.h"

namespace cutis {

// Three of the widest vectors: a tile of 4 units × 3 vectors keeps 12 sums in registers, which is
// what it takes to keep both multipliers of a core busy.
inline constexpr std::size_t kSampleStep = 48;

struct DenseKernelLayer {
  const float* weights;  // [output][input]
  const float* bias;     // [output]
  std::size_t inputs;
  std::size_t outputs;
  Activation activation;
};

// out[output][stride] from in[input][stride]; the two do not overlap.
void forwardLayer(const DenseKernelLayer& layer, const float* in, float* out, std::size_t stride);

// gradient *= slope of the activation where its output was `out`, for `count` numbers, a multiple
// of kSampleStep.
void throughActivation(Activation activation, const float* out, float* gradient, std::size_t count);

// weightGradient[output][input] += Σ gradient[output][·] in[input][·], and the same of the biases.
void addWeightGradient(const float* gradient, std::size_t outputs, const float* in,
                       std::size_t inputs, std::size_t stride, float* weightGradient,
                       float* biasGradient);

}  // namespace cutis
