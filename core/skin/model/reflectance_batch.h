#pragma once

// The vectorised forward model: many pixels at the nodes of a CompiledModel.
//
// Against SkinModel the float results are within 2e-6 in reflectance over the whole parameter box
// and grid, the double results within 1e-12. Derivatives agree within 1e-4 · max(|∂R|, 1e-3 mm).
// A result depends on its own pixel alone, never on its position or neighbours: any division of the
// work gives the same bits (on one instruction set). NaN in a pixel stays in that pixel.
// Thread-safe.

#include <array>
#include <cstddef>

#include "core/skin/model/compiled_model.h"
#include "core/skin/profile/free_constants.h"

namespace cutis {

// Parameters of `count` pixels, one array per parameter in the order of Parameter. A pixel's own
// constants, indexed by SkinConstant, or null where the profile's hold: only
// core/skin/free/free_response.h knows them.
template <typename T>
struct ParameterBatch {
  std::array<const T*, kParameterCount> values;
  std::size_t count = 0;
  std::array<const T*, kConstantCount> constants = {};
};

// reflectance[node * count + i]. T is float or double.
template <typename T>
void reflectanceBatch(const CompiledModel& model, const ParameterBatch<T>& batch, T* reflectance);

// The same with ∂R/∂σ_a of both layers (mm), laid out like the reflectance.
template <typename T>
void reflectanceBatch(const CompiledModel& model, const ParameterBatch<T>& batch, T* reflectance,
                      T* perEpidermalAbsorption, T* perDermalAbsorption);

}  // namespace cutis
