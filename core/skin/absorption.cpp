#include "core/skin/absorption.h"

#include <cmath>

namespace cutis {
namespace {

Spectrum onGrid(const PowerLaw& law) {
  Spectrum spectrum;
  for (int i = 0; i < kSampleCount; ++i) {
    spectrum[i] = law.coefficient * std::pow(wavelengthNm(i), law.exponent);
  }
  return spectrum;
}

Spectrum onGrid(const BaselineAbsorption& law) {
  Spectrum spectrum;
  for (int i = 0; i < kSampleCount; ++i) {
    const double beyond = wavelengthNm(i) - law.originNm;
    spectrum[i] = law.constant + law.amplitude * std::exp(-beyond / law.decayNm);
  }
  return spectrum;
}

Spectrum wholeBlood(const Profile& profile) {
  return profile.oxygenation * profile.oxyhaemoglobin +
         (1.0 - profile.oxygenation) * profile.deoxyhaemoglobin;
}

}  // namespace

EpidermalAbsorption epidermalAbsorption(const Profile& profile) {
  const Spectrum tissue = onGrid(profile.baseline);
  const double dry = 1.0 - profile.epidermalWater;
  EpidermalAbsorption epidermis;
  epidermis.base = tissue + profile.epidermalWater * profile.water;
  epidermis.eumelanin = dry * onGrid(profile.eumelanin) - tissue;
  epidermis.pheomelanin = dry * onGrid(profile.pheomelanin) - tissue;
  epidermis.blood = dry * wholeBlood(profile) - tissue;
  epidermis.carotene = profile.carotene - tissue;
  return epidermis;
}

DermalAbsorption dermalAbsorption(const Profile& profile) {
  const Spectrum tissue = onGrid(profile.baseline);
  const double dry = 1.0 - profile.dermalWater;
  DermalAbsorption dermis;
  dermis.base = tissue + profile.dermalWater * profile.water;
  dermis.blood = dry * wholeBlood(profile) - tissue;
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

Spectrum epidermalScattering(const Profile& profile) {
  return onGrid(profile.mieScattering) + onGrid(profile.rayleighScattering);
}

}  // namespace cutis
