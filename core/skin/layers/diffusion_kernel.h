#pragma once

// The closed form of core/transport/diffusion.h for many skins at one wavelength, each of its own
// thickness, in double precision: the vectorised part of core/skin/free/free_layers.cpp.
//
// Plain data, see core/skin/layers/node_constants.h. Against the templates there within 1e-12;
// absorption below 1e-6 mm⁻¹ counts as that. A skin's result is its own; NaN stays in its skin.
// Thread-safe.

#include <cstddef>

#include "core/skin/layers/node_constants.h"

namespace cutis {

struct DiffusionArguments {
  NodeConstants<double> node;     // its scattering alone counts
  LayerConstants<double> layers;  // its airGap alone counts
  const double* thicknessMm;
  const double* epidermalAbsorption;  // mm⁻¹
  const double* dermalAbsorption;
  std::size_t count;
  double* reflectance;
  double* perEpidermal;  // mm; null: no derivatives
  double* perDermal;
  double* perThickness;  // mm⁻¹
};

void runDiffusionKernel(const DiffusionArguments& arguments);

}  // namespace cutis
