#include "core/skin/profile/profile.h"

#include <cmath>
#include <utility>

#include "core/base/echoed_text.h"
#include "core/skin/profile/absorption.h"

namespace cutis {
namespace {

// Twenty times the paper's table; 40 MB per channel.
constexpr double kMaximumTableEntries = 1e7;
// Far beyond any pigment; products of such numbers still fit into single precision.
constexpr double kMaximumAbsorptionPerMm = 1e6;

// From clear water to chalk and far beyond both; what transport computes holds between them.
constexpr double kLeastScatteringPerMm = 1e-3, kMostScatteringPerMm = 1e4;
constexpr double kLargestMaximum = 1e6;
constexpr double kSteepestPower = 20.0;

// A shift or a smoothing beyond it would be another chromophore.
constexpr double kMaximumShiftNm = 100.0;
// The limit of places and lengths on the scale of wavelengths.
constexpr double kFarthestNm = 1e5;

bool isBetween(double low, double value, double high) {
  return value >= low && value <= high;
}
bool isFraction(double value) {
  return isBetween(0.0, value, 1.0);
}

Status require(bool condition, const std::string& place, const std::string& field,
               const std::string& demand) {
  if (condition) return {};
  return inputError(place, field + " must be " + demand);
}

// Further chromophores have names of their own and something to absorb with.
Status validateFurther(const Profile& profile, const std::string& place) {
  for (int k = kParameterCount; k < parameterCount(profile); ++k) {
    const Chromophore& own = chromophoreOf(profile, k);
    bool isNew = !own.name.empty();
    for (int j = 0; j < k; ++j)
      isNew = isNew && chromophoreOf(profile, j).name != own.name;
    CUTIS_CHECK(require(isNew, place,
                        "the name of a further chromophore, " + inQuotes(own.name) + ",",
                        "that of no other parameter"));
    CUTIS_CHECK(require(static_cast<bool>(own.absorption), place, own.name + ".absorption",
                        "given, as a spectrum"));
  }
  return {};
}

Status validateParameters(const Profile& profile, const std::string& place) {
  CUTIS_CHECK(validateFurther(profile, place));
  for (int k = 0; k < parameterCount(profile); ++k) {
    const ParameterAxis& axis = axisOf(profile, k);
    const std::string field = "parameters." + chromophoreOf(profile, k).name;
    CUTIS_CHECK(require(axis.maximum > 0.0 && axis.maximum <= kLargestMaximum, place,
                        field + ".maximum", "positive and at most a million"));
    CUTIS_CHECK(require(axis.samples >= 2 && axis.samples <= 256, place, field + ".samples",
                        "between 2 and 256"));
    CUTIS_CHECK(require(axis.exponent >= 1 && axis.exponent <= 3, place, field + ".spacing",
                        "uniform, quadratic or cubic"));
  }
  CUTIS_CHECK(validate(profile.prior, place, "prior."));
  for (const SurfaceLight surface : {SurfaceLight::included, SurfaceLight::removed}) {
    const Discrepancy* discrepancy = profile.discrepancies.of(surface);
    if (discrepancy == nullptr) continue;
    CUTIS_CHECK(
        validate(*discrepancy, place, "discrepancy.surface_" + surfaceLightName(surface) + "."));
  }
  double entries = 1.0;
  for (const ParameterAxis& axis : profile.axes)
    entries *= axis.samples;
  return require(entries <= kMaximumTableEntries, place, "the product of all parameters.*.samples",
                 "at most 10 million, the entries of the largest table of skin");
}

// What one constant absorbs by itself.
Status validateAbsorber(const Spectrum& absorption, const std::string& place,
                        const std::string& field) {
  return require(absorption.isFinite().all() && (absorption.abs() < kMaximumAbsorptionPerMm).all(),
                 place, field, "such that it absorbs below a million per mm from 300 to 1000 nm");
}

Status validateTail(const ExponentialTail& tail, const std::string& place,
                    const std::string& field) {
  CUTIS_CHECK(require(isBetween(-kFarthestNm, tail.originNm, kFarthestNm), place,
                      field + ".origin_nm", "between -100000 and 100000"));
  CUTIS_CHECK(require(tail.decayNm > 0.0 && tail.decayNm <= kFarthestNm, place, field + ".decay_nm",
                      "positive and at most 100000"));
  return validateAbsorber(onGrid(tail), place, field + ".amplitude");
}

Status validateBlood(const BloodOptics& blood, const std::string& place, const std::string& field) {
  CUTIS_CHECK(
      require(isFraction(blood.oxygenation), place, field + ".oxygenation", "between 0 and 1"));
  return require(isBetween(0.0, blood.vesselRadiusMm, 1.0), place, field + ".vessel_radius_mm",
                 "between 0 and 1");
}

Status validateCarotene(const CaroteneInSkin& carotene, const std::string& place) {
  const std::string field = "absorption.carotene.";
  CUTIS_CHECK(
      require(isBetween(0.0, carotene.scale, 100.0), place, field + "scale", "between 0 and 100"));
  CUTIS_CHECK(require(isBetween(-kMaximumShiftNm, carotene.shiftNm, kMaximumShiftNm), place,
                      field + "shift_nm", "between -100 and 100"));
  return require(isBetween(0.0, carotene.smoothingNm, kMaximumShiftNm), place,
                 field + "smoothing_nm", "between 0 and 100");
}

Status validateFat(const Profile& profile, const std::string& place) {
  CUTIS_CHECK(
      require(isFraction(profile.dermalFat), place, "dermis.fat_fraction", "between 0 and 1"));
  CUTIS_CHECK(require(isBetween(0.0, profile.fat.peak, kMaximumAbsorptionPerMm), place,
                      "absorption.fat.peak", "between 0 and a million"));
  CUTIS_CHECK(require(isBetween(0.0, profile.fat.centreNm, kFarthestNm), place,
                      "absorption.fat.centre_nm", "between 0 and 100000"));
  return require(profile.fat.deviationNm > 0.0 && profile.fat.deviationNm <= kFarthestNm, place,
                 "absorption.fat.deviation_nm", "positive and at most 100000");
}

Status validateLaw(const PowerLaw& law, const std::string& place, const std::string& field) {
  CUTIS_CHECK(require(std::abs(law.exponent) <= kSteepestPower, place, field + ".exponent",
                      "between -20 and 20"));
  return require(law.referenceNm > 0.0 && std::isfinite(law.referenceNm), place, field + ".at_nm",
                 "positive");
}

Status validatePigment(const PowerLaw& law, const std::string& place, const std::string& field) {
  CUTIS_CHECK(validateLaw(law, place, field));
  CUTIS_CHECK(require(law.coefficient >= 0.0, place, field + ".coefficient", "zero or positive"));
  return validateAbsorber(onGrid(law), place, field);
}

Status validateTissue(const Profile& profile, const std::string& place) {
  CUTIS_CHECK(require(isFraction(profile.epidermalWater), place, "epidermis.water_fraction",
                      "between 0 and 1"));
  CUTIS_CHECK(
      require(isFraction(profile.dermalWater), place, "dermis.water_fraction", "between 0 and 1"));
  CUTIS_CHECK(validatePigment(profile.eumelanin, place, "absorption.eumelanin"));
  CUTIS_CHECK(validatePigment(profile.pheomelanin, place, "absorption.pheomelanin"));
  CUTIS_CHECK(require(std::abs(profile.baseline.constant) < kMaximumAbsorptionPerMm, place,
                      "absorption.baseline.constant", "below a million"));
  CUTIS_CHECK(validateTail(profile.baseline.tail, place, "absorption.baseline"));
  CUTIS_CHECK(validateTail(profile.epidermalUltraviolet, place, "epidermis.ultraviolet"));
  CUTIS_CHECK(require(isBetween(0.0, profile.dermalBaselineFactor, 10.0), place,
                      "dermis.baseline_factor", "between 0 and 10"));
  CUTIS_CHECK(validateBlood(profile.epidermalBlood, place, "epidermis.blood"));
  CUTIS_CHECK(validateBlood(profile.dermalBlood, place, "dermis.blood"));
  CUTIS_CHECK(require(isBetween(0.0, profile.bloodSmoothingNm, kMaximumShiftNm), place,
                      "absorption.blood_smoothing_nm", "between 0 and 100"));
  CUTIS_CHECK(validateCarotene(profile.caroteneInSkin, place));
  return validateFat(profile, place);
}

Status validateAbsorption(const Profile& profile, const std::string& place) {
  CUTIS_CHECK(validateTissue(profile, place));
  const AbsorptionLaw law(profile);
  for (const std::vector<double>& corner : boxCorners(profile)) {
    for (int i = 0; i < kSampleCount; ++i) {
      const std::string where = " over the whole parameter range, and is not at " +
                                std::to_string(kFirstWavelengthNm + i * kWavelengthStepNm) + " nm";
      const LayerPair layers = law.at(i, corner);
      for (const double absorption : {layers.epidermal, layers.dermal}) {
        CUTIS_CHECK(require(absorption < kMaximumAbsorptionPerMm, place, "absorption",
                            "below a million per mm" + where));
        CUTIS_CHECK(require(absorption >= 0.0, place, "absorption", "positive" + where));
      }
    }
  }
  return {};
}

Status validateScattering(const Profile& profile, const std::string& place) {
  const auto lawIsValid = [&](const ReducedScattering& law, const std::string& field) -> Status {
    CUTIS_CHECK(validateLaw(law.mie, place, field + ".mie_scattering"));
    return validateLaw(law.rayleigh, place, field + ".rayleigh_scattering");
  };
  const auto isPossible = [&](const Spectrum& scattering, const std::string& field) {
    return require(scattering.isFinite().all() && (scattering >= kLeastScatteringPerMm).all() &&
                       (scattering <= kMostScatteringPerMm).all(),
                   place, field, "such that it scatters 0.001 to 10000 per mm from 300 to 1000 nm");
  };
  CUTIS_CHECK(lawIsValid(profile.epidermalScatteringLaw, "epidermis"));
  CUTIS_CHECK(isPossible(epidermalScattering(profile), "epidermis.mie_scattering"));
  if (profile.dermalScatteringLaw) {
    CUTIS_CHECK(lawIsValid(*profile.dermalScatteringLaw, "dermis"));
    return isPossible(dermalScattering(profile), "dermis.mie_scattering");
  }
  CUTIS_CHECK(
      require(profile.dermalScatteringRatio > 0.0 && std::isfinite(profile.dermalScatteringRatio),
              place, "dermis.scattering_ratio", "positive"));
  return isPossible(dermalScattering(profile), "dermis.scattering_ratio");
}

Status validateLayers(const Profile& profile, const std::string& place) {
  CUTIS_CHECK(require(profile.refractiveIndex >= 1.0 && profile.refractiveIndex <= 2.0, place,
                      "refractive_index", "between 1 and 2"));
  CUTIS_CHECK(require(profile.epidermalThicknessMm > 0.0 && profile.epidermalThicknessMm < 10.0,
                      place, "epidermis.thickness_mm", "between 0 and 10"));
  CUTIS_CHECK(validateScattering(profile, place));
  // Below one transport mean free path the slab's reflectance turns negative.
  const double thinnestMm = longestPathMm(profile);
  return require(profile.layerOptics != LayerOpticsKind::diffusion ||
                     profile.epidermalThicknessMm >= thinnestMm,
                 place, "epidermis.thickness_mm",
                 "at least " + std::to_string(thinnestMm) +
                     ", one transport mean free path, for layer_optics \"diffusion\"; a thinner "
                     "epidermis needs adding-doubling");
}

}  // namespace

int parameterCount(const Profile& profile) {
  return kParameterCount + static_cast<int>(profile.further.size());
}

const Chromophore& chromophoreOf(const Profile& profile, int parameter) {
  return parameter < kParameterCount
             ? chromophoreTable()[static_cast<std::size_t>(parameter)]
             : profile.further[static_cast<std::size_t>(parameter - kParameterCount)];
}

const ParameterAxis& axisOf(const Profile& profile, int parameter) {
  return parameter < kParameterCount ? profile.axes[static_cast<std::size_t>(parameter)]
                                     : chromophoreOf(profile, parameter).range;
}

std::vector<std::vector<double>> boxCorners(const Profile& profile) {
  const int count = parameterCount(profile);
  std::vector<std::vector<double>> corners;
  for (int corner = 0; corner < 1 << count; ++corner) {
    std::vector<double> parameters;
    for (int k = 0; k < count; ++k)
      parameters.push_back((corner >> k & 1) * axisOf(profile, k).maximum);
    corners.push_back(std::move(parameters));
  }
  return corners;
}

Status requireFive(const Profile& profile, const std::string& what) {
  if (profile.further.empty()) return {};
  return inputError(profile.name, what + " knows the five parameters alone, and this profile has " +
                                      profile.further.front().name +
                                      " beside them; leave that out, or work with spectra");
}

Status validate(const Profile& profile, const std::string& place) {
  CUTIS_CHECK(validateParameters(profile, place));
  CUTIS_CHECK(validateAbsorption(profile, place));
  return validateLayers(profile, place);
}

}  // namespace cutis
