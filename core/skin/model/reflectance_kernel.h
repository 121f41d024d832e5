#pragma once  // internal to core/skin/model

// Entry points of the vectorised forward model, for core/skin/model/reflectance_batch.cpp.

#include <cstddef>

#include "core/base/pixel_rows.h"
#include "core/skin/layers/node_constants.h"
#include "core/skin/profile/parameter.h"

namespace cutis {

// Free of containers: no inline function of a library is compiled for several instruction sets.
template <typename T>
struct ReflectanceArguments {
  const NodeConstants<T>* nodes;
  std::size_t nodeCount;
  LayerConstants<T> layers;
  PixelRows<const T> parameters;  // their `count` pixels
  PixelRows<T> reflectance;       // a row per node
  PixelRows<T> perEpidermal;      // no data: no derivatives
  PixelRows<T> perDermal;
};

// T is float or double.
template <typename T>
void runReflectanceKernel(const ReflectanceArguments<T>& arguments);

}  // namespace cutis
