#pragma once

// A measured curve, before it is on the grid.

#include <vector>

#include "core/spectra/grid.h"

namespace cutis {

struct SpectralCurve {
  // Strictly increasing, at least one.
  std::vector<double> wavelengthsNm;
  // As many values, in any unit.
  std::vector<double> values;
};

// Linear interpolation onto the grid, zero outside the curve's range.
Spectrum resample(const SpectralCurve& curve);

}  // namespace cutis
