#include "core/skin/profile.h"

#include <cmath>
#include <cstddef>

#include "core/base/content_hash.h"
#include "core/skin/absorption.h"

namespace cutis {
namespace {

// Twenty times the paper's table; 40 MB per channel.
constexpr double kMaximumTableEntries = 1e7;
// Far beyond any pigment; products of such numbers still fit into single precision.
constexpr double kMaximumAbsorptionPerMm = 1e6;

bool isFraction(double value) { return value >= 0.0 && value <= 1.0; }

Status require(bool condition, const std::string& place, const std::string& field,
               const std::string& demand) {
  if (condition) return {};
  return inputError(place, field + " must be " + demand);
}

Status validateParameters(const Profile& profile, const std::string& place) {
  for (const Parameter parameter : kParameters) {
    const auto i = static_cast<std::size_t>(parameter);
    const ParameterAxis& axis = profile.axes[i];
    const std::string field = "parameters." + std::string(parameterName(parameter));
    CUTIS_CHECK(require(axis.maximum > 0.0 && std::isfinite(axis.maximum), place,
                        field + ".maximum", "positive"));
    CUTIS_CHECK(require(axis.samples >= 2 && axis.samples <= 256, place, field + ".samples",
                        "between 2 and 256"));
    CUTIS_CHECK(require(axis.exponent >= 1 && axis.exponent <= 3, place, field + ".spacing",
                        "uniform, quadratic or cubic"));
    const std::string name(parameterName(parameter));
    CUTIS_CHECK(require(std::isfinite(profile.prior.mean[parameter]) &&
                            (!profile.prior.isLog(parameter) || profile.prior.mean[parameter] > 0),
                        place, "prior.mean." + name,
                        "finite, and positive on the log scale"));
    CUTIS_CHECK(require(profile.prior.deviation[parameter] > 0.0 &&
                            std::isfinite(profile.prior.deviation[parameter]),
                        place, "prior.sd." + name, "positive"));
  }
  double entries = 1.0;
  for (const ParameterAxis& axis : profile.axes) entries *= axis.samples;
  return require(entries <= kMaximumTableEntries, place, "the product of all parameters.*.samples",
                 "at most 10 million, the entries of the largest table of skin");
}

Status validateAbsorption(const Profile& profile, const std::string& place) {
  CUTIS_CHECK(require(isFraction(profile.oxygenation), place, "absorption.oxygenation",
                      "between 0 and 1"));
  CUTIS_CHECK(require(isFraction(profile.epidermalWater), place, "epidermis.water_fraction",
                      "between 0 and 1"));
  CUTIS_CHECK(require(isFraction(profile.dermalWater), place, "dermis.water_fraction",
                      "between 0 and 1"));
  CUTIS_CHECK(require(profile.baseline.decayNm > 0.0, place, "absorption.baseline.decay_nm",
                      "positive"));
  const EpidermalAbsorption epidermis = epidermalAbsorption(profile);
  const DermalAbsorption dermis = dermalAbsorption(profile);
  // Absorption is linear in each concentration, so its extremes are at corners of the box.
  for (int corner = 0; corner < 1 << kParameterCount; ++corner) {
    ParameterVector parameters;
    for (int k = 0; k < kParameterCount; ++k) {
      parameters[k] = (corner >> k & 1) != 0 ? profile.axes[static_cast<std::size_t>(k)].maximum : 0.0;
    }
    for (int i = 0; i < kSampleCount; ++i) {
      const std::string where = " over the whole parameter range, and is not at " +
                                std::to_string(kFirstWavelengthNm + i * kWavelengthStepNm) + " nm";
      for (const double absorption : {epidermalAbsorptionAt(epidermis, i, parameters),
                                      dermalAbsorptionAt(dermis, i, parameters)}) {
        CUTIS_CHECK(require(absorption < kMaximumAbsorptionPerMm, place, "absorption",
                            "below a million per mm" + where));
        CUTIS_CHECK(require(absorption >= 0.0, place, "absorption", "positive" + where));
      }
    }
  }
  return {};
}

Status validateLayers(const Profile& profile, const std::string& place) {
  CUTIS_CHECK(require(profile.refractiveIndex >= 1.0 && profile.refractiveIndex <= 2.0, place,
                      "refractive_index", "between 1 and 2"));
  CUTIS_CHECK(require(profile.dermalScatteringRatio > 0.0 &&
                          std::isfinite(profile.dermalScatteringRatio),
                      place, "dermis.scattering_ratio", "positive"));
  CUTIS_CHECK(require(profile.epidermalThicknessMm > 0.0 && profile.epidermalThicknessMm < 10.0,
                      place, "epidermis.thickness_mm", "between 0 and 10"));
  const Spectrum scattering = epidermalScattering(profile);
  CUTIS_CHECK(require(scattering.isFinite().all() && (scattering > 0.0).all(), place,
                      "epidermis.reduced_scattering", "positive from 300 to 1000 nm"));
  // Below one transport mean free path the slab's reflectance turns negative.
  const double longestPathMm = 1.0 / (scattering + epidermalAbsorption(profile).base).minCoeff();
  return require(profile.layerOptics != LayerOpticsKind::diffusion ||
                     profile.epidermalThicknessMm >= longestPathMm,
                 place, "epidermis.thickness_mm",
                 "at least " + std::to_string(longestPathMm) +
                     ", one transport mean free path, for layer_optics \"diffusion\"; a thinner "
                     "epidermis needs adding-doubling");
}

void addLaw(ContentHash& hash, const PowerLaw& law) { hash.add(law.coefficient).add(law.exponent); }

void addSpectrum(ContentHash& hash, const Spectrum& spectrum) {
  hash.add(std::span<const double>(spectrum.data(), static_cast<std::size_t>(spectrum.size())));
}

}  // namespace

Status validate(const Profile& profile, const std::string& place) {
  CUTIS_CHECK(validateParameters(profile, place));
  CUTIS_CHECK(validateAbsorption(profile, place));
  return validateLayers(profile, place);
}

std::string fingerprint(const Profile& profile) {
  ContentHash hash;
  for (const ParameterAxis& axis : profile.axes) {
    hash.add(axis.maximum).add(double(axis.samples)).add(double(axis.exponent));
  }
  for (const PowerLaw& law : {profile.eumelanin, profile.pheomelanin, profile.mieScattering,
                              profile.rayleighScattering}) {
    addLaw(hash, law);
  }
  hash.add(profile.baseline.constant)
      .add(profile.baseline.amplitude)
      .add(profile.baseline.originNm)
      .add(profile.baseline.decayNm);
  for (const Spectrum* spectrum : {&profile.oxyhaemoglobin, &profile.deoxyhaemoglobin,
                                   &profile.water, &profile.carotene}) {
    addSpectrum(hash, *spectrum);
  }
  hash.add(profile.oxygenation)
      .add(profile.epidermalWater)
      .add(profile.dermalWater)
      .add(profile.dermalScatteringRatio)
      .add(profile.epidermalThicknessMm)
      .add(profile.refractiveIndex)
      .add(double(static_cast<int>(profile.layerOptics)));
  return hash.digest();
}

}  // namespace cutis
