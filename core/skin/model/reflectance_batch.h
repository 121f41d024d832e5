#pragma once

// The vectorised forward model: many pixels at the nodes of a CompiledModel.
//
// Against SkinModel the float results are within 2e-6 in reflectance over the whole parameter box
// and grid, the double results within 1e-12. Derivatives agree within 1e-4 · max(|∂R|, 1e-3 mm).
// A result depends on its own pixel alone, never on its position or neighbours: any division of the
// work gives the same bits (on one instruction set). NaN in a pixel stays in that pixel.
// Thread-safe.

#include <span>

#include "core/base/pixel_rows.h"
#include "core/skin/model/compiled_model.h"

namespace cutis {

// A row per parameter, in the order of Parameter. T is float or double.
template <typename T>
PixelBuffer<T> parameterRows(std::span<const ParameterVector> people);

// parameters: as parameterRows() gives them; what follows the five rows is left alone. reflectance:
// a row per node, as many pixels as there are parameters. T is float or double.
template <typename T>
void reflectanceBatch(const CompiledModel& model, PixelRows<const T> parameters,
                      PixelRows<T> reflectance);

// The same with ∂R/∂σ_a of both layers (mm), laid out like the reflectance.
template <typename T>
void reflectanceBatch(const CompiledModel& model, PixelRows<const T> parameters,
                      PixelRows<T> reflectance, PixelRows<T> perEpidermalAbsorption,
                      PixelRows<T> perDermalAbsorption);

}  // namespace cutis
