#pragma once  // internal to core/skin

// Vectorised part of core/skin/response_model.cpp. Plain data, see node_constants.h.

#include <cstddef>

#include "core/base/pixel_rows.h"
#include "core/skin/layers/node_constants.h"
#include "core/skin/profile/parameter.h"

namespace cutis {

inline constexpr int kMaximumResponseRows = 4;

struct ResponseArguments {
  const NodeConstants<float>* nodes;
  std::size_t nodeCount;
  LayerConstants<float> layers;
  PixelRows<const float> parameters;  // their `count` pixels
  // The coefficients of the discrepancy, a row each; none: there is none.
  PixelRows<const float> coefficients;
  // [node][weightStride], the first rowCount of each are used; behind each node's, at a distance of
  // coefficientStride, what a coefficient adds to them.
  const float* weights;
  std::size_t weightStride;
  std::size_t coefficientStride;
  std::size_t rowCount;  // at most kMaximumResponseRows
  float* const* out;     // [row][pixel]: the rows of a picture lie where they like
};

void runResponseKernel(const ResponseArguments& arguments);

}  // namespace cutis
