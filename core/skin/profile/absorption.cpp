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

EpidermalAbsorption epidermalAbsorption(const Profile& profile) {
  Spectrum tissue = baselineOf(profile);
  if (profile.epidermalUltraviolet.amplitude != 0.0) {
    tissue += onGrid(profile.epidermalUltraviolet);
  }
  const CaroteneInSkin& carotene = profile.caroteneInSkin;
  const double dry = 1.0 - profile.epidermalWater;
  EpidermalAbsorption epidermis;
  epidermis.base = tissue + profile.epidermalWater * profile.water;
  epidermis.eumelanin = dry * onGrid(profile.eumelanin) - tissue;
  epidermis.pheomelanin = dry * onGrid(profile.pheomelanin) - tissue;
  epidermis.blood = dry * bloodIn(profile, profile.epidermalBlood) - tissue;
  epidermis.carotene = carotene.scale * shiftedAndSmoothed(profile.carotene, carotene.shiftNm,
                                                           carotene.smoothingNm) -
                       tissue;
  return epidermis;
}

DermalAbsorption dermalAbsorption(const Profile& profile) {
  const Spectrum tissue = profile.dermalBaselineFactor * baselineOf(profile);
  const double dry = 1.0 - profile.dermalWater;
  DermalAbsorption dermis;
  dermis.base = tissue + profile.dermalWater * profile.water;
  if (profile.dermalFat != 0.0) dermis.base += profile.dermalFat * onGrid(profile.fat);
  dermis.blood = dry * bloodIn(profile, profile.dermalBlood) - tissue;
  return dermis;
}

double epidermalAbsorptionAt(const EpidermalAbsorption& epidermis, int sample,
                             const ParameterVector& parameters) {
  const double blend = parameters[kMelaninBlend];
  const double melanin =
      blend * epidermis.eumelanin[sample] + (1.0 - blend) * epidermis.pheomelanin[sample];
  return epidermis.base[sample] + parameters[kMelanin] * melanin +
         parameters[kHaemoglobinEpidermal] * epidermis.blood[sample] +
         parameters[kCarotene] * epidermis.carotene[sample];
}

double dermalAbsorptionAt(const DermalAbsorption& dermis, int sample,
                          const ParameterVector& parameters) {
  return dermis.base[sample] + parameters[kHaemoglobinDermal] * dermis.blood[sample];
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
  return 1.0 / (epidermalScattering(profile) + epidermalAbsorption(profile).base).minCoeff();
}

}  // namespace cutis
