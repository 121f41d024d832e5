#pragma once

// The vectorised table: many pairs of absorptions at one wavelength.
//
// Against the double evaluate() of core/skin/layers/polynomial_fit.h the float results are within
// 2e-6 in reflectance and 1e-3 · max(|∂R|, 1e-2 mm) in the derivatives, the double results within
// 1e-13. A result depends on its own pair alone, never on its place. NaN stays in its pair.
// Thread-safe.

#include <cstddef>

#include "core/skin/layers/polynomial.h"

namespace cutis {

// `count` absorptions of either layer, mm⁻¹, and room for as many results. Derivatives (mm) are
// left out where their pointers are null, both or none. T is float or double.
template <typename T>
struct LayerTableBatch {
  const T* epidermalAbsorption = nullptr;
  const T* dermalAbsorption = nullptr;
  std::size_t count = 0;
  T* reflectance = nullptr;
  T* perEpidermalAbsorption = nullptr;
  T* perDermalAbsorption = nullptr;
};

template <typename T>
void evaluateBatch(const LayerPolynomial<T>& polynomial, const LayerTableBatch<T>& batch);

}  // namespace cutis
