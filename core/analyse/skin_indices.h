#pragma once

// What dermatology says of skin in one number each, from a reflectance spectrum.
//
//   ITA°             = atan((L* − 50) / b*) · 180 / π      Chardon et al. 1991; D65, 2°
//   melanin index    = 100 · (A650 + A700) / 2
//   erythema index   = 100 · (A560 − (A650 + A510) / 2)
//   Dawson's index   = 100 · (r + 1.5 (q + s) − 2 (p + t)) Dawson et al. 1980
//
// with A = log10(1 / R) at the wavelength in nm, and p, q, r, s, t = A at 510, 540, 560, 580 and
// 610 nm. Reflectances are shares of the perfect diffuser; a logarithm of what is not positive is
// NaN, and so is every index that takes it. Pure functions, thread-safe, double precision.

#include <Eigen/Core>

#include "core/spectra/grid.h"

namespace cutis {

struct SkinIndices {
  double typologyAngle = 0.0;  // ITA, degrees
  double melanin = 0.0;
  double erythema = 0.0;
  double dawsonErythema = 0.0;
};

// CIELAB of a reflectance. tristimulus: tristimulusRows() of light and observer
// (core/spectra/colorimetry.h), of which a perfect diffuser is the white.
Eigen::Vector3d labOf(const Spectrum& reflectance, const SpectrumRows& tristimulus);

// tristimulus: of D65 and the observer CIE 1931, for the typology angle.
SkinIndices skinIndices(const Spectrum& reflectance, const SpectrumRows& tristimulus);

}  // namespace cutis
