#pragma once  // internal to core/skin/layers

// Entry points of the vectorised table, for core/skin/layers/table_batch.cpp.

#include <cstddef>

#include "core/skin/layers/polynomial.h"

namespace cutis {

// Free of containers: no inline function of a library is compiled for several instruction sets.
template <typename T>
struct LayerTableArguments {
  const LayerPolynomial<T>* polynomial;
  const T* epidermalAbsorption;
  const T* dermalAbsorption;
  std::size_t count;
  T* reflectance;
  T* perEpidermal;  // null: no derivatives
  T* perDermal;
};

// T is float or double.
template <typename T>
void runLayerTableKernel(const LayerTableArguments<T>& arguments);

}  // namespace cutis
