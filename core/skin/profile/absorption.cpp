#include "core/skin/profile/absorption.h"

#include <cmath>

namespace cutis {
namespace {

// Tissue of both layers.
Spectrum baselineOf(const Profile& profile) {
  return profile.baseline.constant + onGrid(profile.baseline.tail);
}

Spectrum scatteringOf(const ReducedScattering& law) {
  return onGrid(law.mie) + onGrid(law.rayleigh);
}

}  // namespace

AbsorptionLaw::AbsorptionLaw(const Profile& profile) {
  std::vector<Spectrum> columns = {baseIn(profile, SkinLayer::epidermis),
                                   baseIn(profile, SkinLayer::dermis)};
  for (int k = 0; k < cutis::parameterCount(profile); ++k) {
    layers_.push_back(chromophoreOf(profile, k).layer);
    columns.push_back(chromophoreOf(profile, k).absorption(profile));
  }
  coefficients_.reserve(columns.size() * kSampleCount);
  for (int i = 0; i < kSampleCount; ++i) {
    for (const Spectrum& column : columns)
      coefficients_.push_back(column[i]);
  }
}

double AbsorptionLaw::base(SkinLayer layer, int sample) const {
  return ofSample(sample)[layer == SkinLayer::epidermis ? 0 : 1];
}

double waterIn(const Profile& profile, SkinLayer layer) {
  return layer == SkinLayer::epidermis ? profile.epidermalWater : profile.dermalWater;
}

Spectrum tissueIn(const Profile& profile, SkinLayer layer) {
  if (layer == SkinLayer::dermis) return profile.dermalBaselineFactor * baselineOf(profile);
  Spectrum tissue = baselineOf(profile);
  if (profile.epidermalUltraviolet.amplitude != 0.0) {
    tissue += onGrid(profile.epidermalUltraviolet);
  }
  return tissue;
}

Spectrum baseIn(const Profile& profile, SkinLayer layer) {
  Spectrum base = tissueIn(profile, layer) + waterIn(profile, layer) * profile.water;
  const bool hasFat = layer == SkinLayer::dermis && profile.dermalFat != 0.0;
  if (hasFat) base += profile.dermalFat * onGrid(profile.fat);
  return base;
}

double packagingFactor(double absorptionPerMm, double radiusMm) {
  const double depth = 2.0 * absorptionPerMm * radiusMm;
  // The quotient loses its digits where it is 1 to within them.
  return depth > 1e-12 ? -std::expm1(-depth) / depth : 1.0;
}

Spectrum bloodIn(const Profile& profile, const BloodOptics& layer) {
  Spectrum blood = layer.oxygenation * profile.oxyhaemoglobin +
                   (1.0 - layer.oxygenation) * profile.deoxyhaemoglobin;
  for (double& absorption : blood) {
    absorption *= packagingFactor(absorption, layer.vesselRadiusMm);
  }
  return smoothed(blood, profile.bloodSmoothingNm);
}

Spectrum epidermalScattering(const Profile& profile) {
  return scatteringOf(profile.epidermalScatteringLaw);
}

Spectrum dermalScattering(const Profile& profile) {
  if (profile.dermalScatteringLaw) return scatteringOf(*profile.dermalScatteringLaw);
  return profile.dermalScatteringRatio * epidermalScattering(profile);
}

double longestPathMm(const Profile& profile) {
  return 1.0 / (epidermalScattering(profile) + baseIn(profile, SkinLayer::epidermis)).minCoeff();
}

}  // namespace cutis
