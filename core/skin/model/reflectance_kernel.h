#pragma once  // internal to core/skin/model

// Entry points of the vectorised forward model, for core/skin/model/reflectance_batch.cpp.

#include <cstddef>

#include "core/skin/layers/node_constants.h"
#include "core/skin/profile/parameter.h"

namespace cutis {

// Free of containers: no inline function of a library is compiled for several instruction sets.
template <typename T>
struct BatchArguments {
  const NodeConstants<T>* nodes;
  std::size_t nodeCount;
  LayerConstants<T> layers;
  const T* parameters[kParameterCount];
  std::size_t count;
  T* reflectance;
  T* perEpidermal;  // null: no derivatives
  T* perDermal;
};

// T is float or double.
template <typename T>
void runReflectanceKernel(const BatchArguments<T>& arguments);

}  // namespace cutis
