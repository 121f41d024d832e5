#pragma once

// The polynomial of two layers at one wavelength, fitted to adding–doubling.

#include "core/base/result.h"
#include "core/skin/layers/optics.h"
#include "core/skin/layers/polynomial.h"
#include "core/transport/adding_doubling.h"

namespace cutis {

// mm⁻¹; 0 ≤ low ≤ high.
struct AbsorptionRange {
  double low = 0.0;
  double high = 0.0;
};

// Scattering (reduced) in mm⁻¹, thickness of the epidermis in mm.
struct TwoLayers {
  double thickness = 0.0;
  double epidermalScattering = 0.0;  // positive, as dermalScattering
  double dermalScattering = 0.0;
  AbsorptionRange epidermalRange;
  AbsorptionRange dermalRange;
};

// Least squares over adding–doubling at 20 × 11 absorptions, Chebyshev points of the range widened
// by 2 % at both ends (to at least 5 % in all, and to absorptions of at least 1e-4 mm⁻¹); the knees
// are those of a short list that fit best. The result is the reflectance of the diffuse part per
// flux that enters. Deterministic; about 2 ms with 16 streams, which adding–doubling takes.
// Thread-safe. Errors: those of adding–doubling, and ranges that are none.
Result<LayerPolynomial<double>> fitLayerPolynomial(const TwoLayers& layers,
                                                   const TransportOptions& options = {});

// The form that kernels read: coefficients are rounded, no more.
LayerPolynomial<float> singlePrecision(const LayerPolynomial<double>& polynomial);

// Value and derivatives in double precision: the oracle of the vectorised forms. Absorptions as
// core/skin/layers/table-inl.h has them; NaN gives NaN. About 60 ns.
LayeredReflectance evaluate(const LayerPolynomial<double>& polynomial, double epidermalAbsorption,
                            double dermalAbsorption);

}  // namespace cutis
