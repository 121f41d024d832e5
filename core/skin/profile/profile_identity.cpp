// Who a profile is: as a hash, and as numbers with a tolerance.

#include <cstddef>
#include <span>
#include <string_view>

#include "core/base/content_hash.h"
#include "core/skin/profile/profile_signature.h"

namespace cutis {
namespace {

// A sink is a ContentHash or a SignatureBuilder.

template <typename Sink>
void addLaw(Sink& sink, const PowerLaw& law) {
  sink.add(law.coefficient).add(law.exponent);
}

template <typename Sink>
void addSpectrum(Sink& sink, const Spectrum& spectrum) {
  sink.add(std::span<const double>(spectrum.data(), static_cast<std::size_t>(spectrum.size())));
}

// What the paper's model does not have counts only where it is used, so that tables of the paper's
// model keep the name they were kept under.
template <typename Sink>
void addUnless(double usual, Sink& sink, std::string_view name, double value) {
  if (value != usual) sink.add(name).add(value);
}

template <typename Sink>
void addScattering(Sink& sink, const ReducedScattering& law) {
  addLaw(sink, law.mie);
  addLaw(sink, law.rayleigh);
  sink.add(law.mie.referenceNm).add(law.rayleigh.referenceNm);
}

template <typename Sink>
void addBeyondThePaper(Sink& sink, const Profile& profile) {
  const ReducedScattering& scattering = profile.epidermalScatteringLaw;
  addUnless(1.0, sink, "eumelanin at", profile.eumelanin.referenceNm);
  addUnless(1.0, sink, "pheomelanin at", profile.pheomelanin.referenceNm);
  addUnless(1.0, sink, "mie at", scattering.mie.referenceNm);
  addUnless(1.0, sink, "rayleigh at", scattering.rayleigh.referenceNm);
  addUnless(profile.dermalBlood.oxygenation, sink, "epidermal oxygenation",
            profile.epidermalBlood.oxygenation);
  addUnless(0.0, sink, "epidermal vessels", profile.epidermalBlood.vesselRadiusMm);
  addUnless(0.0, sink, "dermal vessels", profile.dermalBlood.vesselRadiusMm);
  addUnless(0.0, sink, "blood smoothing", profile.bloodSmoothingNm);
  addUnless(1.0, sink, "carotene scale", profile.caroteneInSkin.scale);
  addUnless(0.0, sink, "carotene shift", profile.caroteneInSkin.shiftNm);
  addUnless(0.0, sink, "carotene smoothing", profile.caroteneInSkin.smoothingNm);
  addUnless(1.0, sink, "dermal baseline", profile.dermalBaselineFactor);
  const ExponentialTail& tail = profile.epidermalUltraviolet;
  if (tail.amplitude != 0.0) {
    sink.add("ultraviolet").add(tail.amplitude).add(tail.originNm).add(tail.decayNm);
  }
  const GaussianBand& fat = profile.fat;
  if (profile.dermalFat != 0.0) {
    sink.add("fat").add(profile.dermalFat);
    sink.add(fat.peak).add(fat.centreNm).add(fat.deviationNm);
  }
  if (profile.dermalScatteringLaw) {
    sink.add("dermal scattering");
    addScattering(sink, *profile.dermalScatteringLaw);
  }
  for (const Chromophore& further : profile.further) {
    sink.add("further").add(std::string_view(further.name));
    sink.add(double(static_cast<int>(further.layer))).add(further.range.maximum);
    addSpectrum(sink, further.absorption(profile));
  }
}

template <typename Sink>
void addProfile(Sink& sink, const Profile& profile) {
  for (const ParameterAxis& axis : profile.axes) {
    sink.add(axis.maximum).add(double(axis.samples)).add(double(axis.exponent));
  }
  for (const PowerLaw& law :
       {profile.eumelanin, profile.pheomelanin, profile.epidermalScatteringLaw.mie,
        profile.epidermalScatteringLaw.rayleigh}) {
    addLaw(sink, law);
  }
  sink.add(profile.baseline.constant)
      .add(profile.baseline.tail.amplitude)
      .add(profile.baseline.tail.originNm)
      .add(profile.baseline.tail.decayNm);
  for (const Spectrum* spectrum :
       {&profile.oxyhaemoglobin, &profile.deoxyhaemoglobin, &profile.water, &profile.carotene}) {
    addSpectrum(sink, *spectrum);
  }
  const bool hasRatio = !profile.dermalScatteringLaw;
  sink.add(profile.dermalBlood.oxygenation)
      .add(profile.epidermalWater)
      .add(profile.dermalWater)
      .add(hasRatio ? profile.dermalScatteringRatio : 0.0)
      .add(profile.epidermalThicknessMm)
      .add(profile.refractiveIndex)
      .add(double(static_cast<int>(profile.layerOptics)));
  addBeyondThePaper(sink, profile);
}

}  // namespace

std::string fingerprint(const Profile& profile) {
  ContentHash hash;
  addProfile(hash, profile);
  return hash.digest();
}

Signature signatureOf(const Profile& profile) {
  SignatureBuilder builder;
  addProfile(builder, profile);
  return builder.signature();
}

}  // namespace cutis
