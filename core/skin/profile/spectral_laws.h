#pragma once  // internal to core/skin/profile

// Formulas of the wavelength λ (nm) that the skin model's constants stand in, and what they give on
// the grid. What a value means, mm⁻¹ as a rule, is said by the field that holds the law.
//
// Parameters are finite; lengths that divide (reference, decay, deviation) are positive. Other
// values, NaN included, give meaningless spectra; profiles are checked by validate(). Thread-safe:
// pure functions.

#include "core/spectra/grid.h"

namespace cutis {

// coefficient · (λ / reference)^exponent
struct PowerLaw {
  double coefficient = 0.0;
  double exponent = 0.0;
  double referenceNm = 1.0;  // where the law is worth its coefficient
};

// amplitude · exp(−(λ − origin) / decay)
struct ExponentialTail {
  double amplitude = 0.0;
  double originNm = 0.0;
  double decayNm = 1.0;
};

// peak · exp(−½ ((λ − centre) / deviation)²)
struct GaussianBand {
  double peak = 0.0;
  double centreNm = 0.0;
  double deviationNm = 1.0;
};

Spectrum onGrid(const PowerLaw& law);
Spectrum onGrid(const ExponentialTail& tail);
Spectrum onGrid(const GaussianBand& band);

// The spectrum seen through a Gaussian of that standard deviation. At the ends of the grid the
// weights are of what there is: nothing is invented beyond it. Deviation 0: the spectrum itself.
Spectrum smoothed(const Spectrum& spectrum, double deviationNm);

// The spectrum moved towards longer wavelengths and smoothed; beyond the grid it keeps the value at
// its end, because a shift asks for what lies there. Linear between samples. Shift and deviation 0:
// the spectrum itself.
Spectrum shiftedAndSmoothed(const Spectrum& spectrum, double shiftNm, double deviationNm);

}  // namespace cutis
