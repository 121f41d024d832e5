#include "core/analyse/skin_indices.h"

#include <cmath>
#include <limits>

#include "core/spectra/colorimetry.h"

namespace cutis {
namespace {

// log10(1 / R) at a wavelength of the grid.
double absorbance(const Spectrum& reflectance, int nm) {
  const double value = reflectance[(nm - kFirstWavelengthNm) / kWavelengthStepNm];
  return value > 0.0 ? -std::log10(value) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Eigen::Vector3d labOf(const Spectrum& reflectance, const SpectrumRows& tristimulus) {
  const Eigen::Vector3d white = tristimulus.rowwise().sum().matrix();
  return labFromXyz(tristimulus.matrix() * reflectance.matrix(), white);
}

SkinIndices skinIndices(const Spectrum& reflectance, const SpectrumRows& tristimulus) {
  const auto at = [&](int nm) { return absorbance(reflectance, nm); };
  SkinIndices indices;
  indices.typologyAngle = individualTypologyAngle(labOf(reflectance, tristimulus));
  indices.melanin = 100.0 * (at(650) + at(700)) / 2.0;
  indices.erythema = 100.0 * (at(560) - (at(650) + at(510)) / 2.0);
  indices.dawsonErythema =
      100.0 * (at(560) + 1.5 * (at(540) + at(580)) - 2.0 * (at(510) + at(610)));
  return indices;
}

}  // namespace cutis
