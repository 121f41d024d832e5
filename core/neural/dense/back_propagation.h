#pragma once  // internal to core/neural/dense

// The error of a network over some samples and its gradient by the network's weights, by
// back-propagation: the inner part of core/neural/dense/trainer.h.
//
//   error = Σ_samples Σ_outputs targetWeight · (output − target)²

#include <cstddef>
#include <vector>

#include "core/base/pixel_rows.h"
#include "core/neural/dense/aligned_floats.h"
#include "core/neural/dense/dense_network.h"

namespace cutis {

// Layers [first, last) are trained, the others stay as they are.
struct TrainedLayers {
  std::size_t first = 0;
  std::size_t last = kMaximumLayers;
};

// A row per unit, a sample in place of a pixel. Rows are as long as their stride, a multiple of
// kSampleStep: what follows the samples that count must be finite, too.
struct SamplePiece {
  PixelRows<const float> inputs;
  PixelRows<const float> targets;
};

// What a piece needs while it is worked on; grows to what it needs and can be used again.
struct PropagationScratch {
  std::vector<AlignedFloats> outputs;  // by layer
  AlignedFloats gradient;
  AlignedFloats gradientBelow;
};

// Thread-safe: const after construction. The network outlives it and does not change.
class BackPropagation {
 public:
  BackPropagation(const DenseNetwork& network, const std::vector<float>& targetWeights,
                  TrainedLayers trained);

  double error(const SamplePiece& piece, PropagationScratch& scratch) const;

  // Adds to the gradient: one number per weight and bias of the trained layers, layer by layer,
  // weights first. Returns the error.
  double addGradient(const SamplePiece& piece, PropagationScratch& scratch, float* gradient) const;

  // Length of the gradient.
  std::size_t gradientSize() const { return gradientSize_; }

 private:
  void forward(const SamplePiece& piece, PropagationScratch& scratch) const;
  // Turns the last outputs into the gradient by them.
  double compare(const SamplePiece& piece, PropagationScratch& scratch) const;

  const DenseNetwork& network_;
  std::vector<float> targetWeights_;
  TrainedLayers trained_;
  std::size_t gradientSize_ = 0;
  std::vector<std::vector<float>> transposed_;  // weights by layer, [input][output]
  std::vector<float> noBias_;
};

}  // namespace cutis
