#pragma once

// Reflectance spectra as they were measured, at wavelengths of their own.
//
// Wavelengths in nm, reflectances as shares of the perfect diffuser, finite. Pure functions.

#include <span>
#include <string>
#include <vector>

#include "core/spectra/grid.h"

namespace cutis {

// Both ends included.
struct WavelengthRange {
  double fromNm = 400.0;
  double toNm = 700.0;

  bool contains(double wavelengthNm) const {
    return wavelengthNm >= fromNm && wavelengthNm <= toNm;
  }
};

struct MeasuredSpectra {
  std::vector<std::string> ids;       // one per spectrum, not empty, not necessarily different
  std::vector<double> wavelengthsNm;  // strictly increasing, within the model's grid
  std::vector<double> reflectances;   // [spectrum][wavelength], from 0 to kMostReflectance
};

// Above 1 by the error of a measurement; what is beyond is percent.
inline constexpr double kMostReflectance = 1.5;

// [wavelength] of one spectrum.
std::span<const double> spectrumAt(const MeasuredSpectra& spectra, std::size_t index);

// One spectrum on the model's grid: linear between the measured wavelengths, of which there are at
// least two, and beyond them.
Spectrum onGrid(const MeasuredSpectra& spectra, std::size_t index);

// Some of the spectra, in the order given; one may come several times.
MeasuredSpectra selected(const MeasuredSpectra& spectra, std::span<const std::size_t> indices);

}  // namespace cutis
