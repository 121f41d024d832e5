#pragma once  // internal to core/neural

// Vectorised passes through networks for many pixels: the inner part of
// core/neural/network_pipeline.cpp. Plain data.
//
// kSampleStep pixels go through all layers while they are in the first cache. One pixel a lane; a
// result depends on its own pixel alone. An input that is not finite makes all outputs of its pixel
// NaN.

#include <cstddef>

#include "core/base/pixel_rows.h"
#include "core/neural/dense/dense_kernel.h"
#include "core/skin/profile/parameter.h"

namespace cutis {

// A parameter's axis: value = maximum · coordinate^exponent.
struct KernelAxis {
  float maximum;
  float inverseMaximum;
  int exponent;  // 1 to 3
};

struct NetworkPass {
  // Leads from logarithms of channels to coordinates of parameters; none where the inputs are
  // parameters.
  const DenseKernelLayer* encoder = nullptr;
  std::size_t encoderLayers = 0;
  // From coordinates to the rows asked for; none where only parameters are.
  const DenseKernelLayer* decoder = nullptr;
  std::size_t decoderLayers = 0;
  KernelAxis axes[kParameterCount] = {};
  float smallestChannel = 0.0f;  // channels below count as this

  std::size_t inputCount = 0;
  std::size_t outputCount = 0;  // of the decoder
  std::size_t widest = 0;       // units of the widest layer, inputs and outputs included
};

// Floats of scratch that a pass needs.
std::size_t networkScratchSize(const NetworkPass& pass);

// A row per input, parameter or output, of as many pixels as there are inputs. parameters: without
// data nobody asks for them; outputs: without data where there is no decoder. scratch: aligned as
// in core/neural/dense/aligned_floats.h, or slower.
void runNetworkKernel(const NetworkPass& pass, PixelRows<const float> inputs,
                      PixelRows<float> parameters, PixelRows<float> outputs, float* scratch);

}  // namespace cutis
