#include "src/files/profiles/profile_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "core/base/echoed_text.h"
#include "core/skin/profile/parameter_names.h"
#include "src/files/io/json_file.h"
#include "src/files/io/suggestion.h"
#include "src/files/io/text_file.h"
#include "src/files/profiles/discrepancy_file.h"
#include "src/files/profiles/prior_file.h"
#include "src/files/resources.h"
#include "src/files/spectral_library.h"

namespace cutis {
namespace {

constexpr int kNewestProfile = 1;
constexpr std::array<std::string_view, 3> kSpacings = {"uniform", "quadratic", "cubic"};

Result<PowerLaw> parsePowerLaw(const JsonValue& parent, const std::string& key) {
  CUTIS_TRY(object, parent.object(key));
  CUTIS_CHECK(object.allowOnly({"coefficient", "exponent", "at_nm"}));
  CUTIS_TRY(coefficient, object.number("coefficient"));
  CUTIS_TRY(exponent, object.number("exponent"));
  CUTIS_TRY(reference, object.number("at_nm", 1.0));
  return PowerLaw{coefficient, exponent, reference};
}

Result<ReducedScattering> parseScattering(const JsonValue& layer) {
  CUTIS_TRY(mie, parsePowerLaw(layer, "mie_scattering"));
  CUTIS_TRY(rayleigh, parsePowerLaw(layer, "rayleigh_scattering"));
  return ReducedScattering{mie, rayleigh};
}

Result<ParameterAxis> parseAxis(const JsonValue& parent, const std::string& key) {
  CUTIS_TRY(object, parent.object(key));
  CUTIS_CHECK(object.allowOnly({"maximum", "samples", "spacing", "unit"}));
  CUTIS_TRY(maximum, object.number("maximum"));
  CUTIS_TRY(samples, object.integer("samples"));
  CUTIS_TRY(spacing, object.text("spacing"));
  const auto found = std::find(kSpacings.begin(), kSpacings.end(), spacing);
  if (found == kSpacings.end()) {
    return object.error("spacing", "\"uniform\", \"quadratic\" or \"cubic\"");
  }
  return ParameterAxis{maximum, samples, static_cast<int>(found - kSpacings.begin()) + 1};
}

Status parseParameters(const JsonValue& root, Profile& profile) {
  CUTIS_TRY(parameters, root.object("parameters"));
  CUTIS_CHECK(parameters.allowOnly(parameterNames()));
  for (const Parameter parameter : kParameters) {
    CUTIS_TRY(axis, parseAxis(parameters, std::string(parameterName(parameter))));
    profile.axes[static_cast<std::size_t>(parameter)] = axis;
  }
  return {};
}

Status parseChromophores(const JsonValue& absorption, Profile& profile) {
  CUTIS_TRY(name, absorption.text("chromophores"));
  const std::filesystem::path file = absorption.file();
  CUTIS_TRY(table, loadChromophores({name, file.parent_path(), absorption.file()}));
  const std::array<std::pair<const char*, Spectrum*>, 4> columns = {
      {{"oxyhaemoglobin", &profile.oxyhaemoglobin},
       {"deoxyhaemoglobin", &profile.deoxyhaemoglobin},
       {"water", &profile.water},
       {"carotene", &profile.carotene}}};
  for (const auto& [column, spectrum] : columns) {
    const auto found = std::find(table.names.begin(), table.names.end(), column);
    if (found == table.names.end()) {
      return inputError(table.place, std::string("the header must name a column ") + column);
    }
    *spectrum = table.onGrid(static_cast<std::size_t>(found - table.names.begin()));
  }
  return {};
}

// Fields every exponential tail has; the object may have more.
Result<ExponentialTail> parseTail(const JsonValue& object) {
  CUTIS_TRY(amplitude, object.number("amplitude"));
  CUTIS_TRY(origin, object.number("origin_nm"));
  CUTIS_TRY(decay, object.number("decay_nm"));
  return ExponentialTail{amplitude, origin, decay};
}

Result<CaroteneInSkin> parseCarotene(const JsonValue& absorption) {
  CaroteneInSkin carotene;
  if (!absorption.has("carotene")) return carotene;
  CUTIS_TRY(object, absorption.object("carotene"));
  CUTIS_CHECK(object.allowOnly({"scale", "shift_nm", "smoothing_nm"}));
  CUTIS_TRY(scale, object.number("scale", carotene.scale));
  CUTIS_TRY(shift, object.number("shift_nm", carotene.shiftNm));
  CUTIS_TRY(smoothing, object.number("smoothing_nm", carotene.smoothingNm));
  return CaroteneInSkin{scale, shift, smoothing};
}

Status parseAbsorption(const JsonValue& root, Profile& profile) {
  CUTIS_TRY(absorption, root.object("absorption"));
  CUTIS_CHECK(absorption.allowOnly({"chromophores", "eumelanin", "pheomelanin", "baseline",
                                    "oxygenation", "blood_smoothing_nm", "carotene", "fat"}));
  CUTIS_TRY(eumelanin, parsePowerLaw(absorption, "eumelanin"));
  CUTIS_TRY(pheomelanin, parsePowerLaw(absorption, "pheomelanin"));
  CUTIS_TRY(baseline, absorption.object("baseline"));
  CUTIS_CHECK(baseline.allowOnly({"constant", "amplitude", "origin_nm", "decay_nm"}));
  CUTIS_TRY(constant, baseline.number("constant"));
  CUTIS_TRY(tail, parseTail(baseline));
  CUTIS_TRY(smoothing, absorption.number("blood_smoothing_nm", 0.0));
  CUTIS_TRY(carotene, parseCarotene(absorption));
  profile.eumelanin = eumelanin;
  profile.pheomelanin = pheomelanin;
  profile.baseline = {constant, tail};
  profile.bloodSmoothingNm = smoothing;
  profile.caroteneInSkin = carotene;
  return parseChromophores(absorption, profile);
}

// The blood of one layer; without an oxygenation of its own it has `shared`.
Result<BloodOptics> parseLayerBlood(const JsonValue& layer, double shared) {
  BloodOptics blood = {shared};
  if (!layer.has("blood")) return blood;
  CUTIS_TRY(object, layer.object("blood"));
  CUTIS_CHECK(object.allowOnly({"oxygenation", "vessel_radius_mm"}));
  CUTIS_TRY(oxygenation, object.number("oxygenation", shared));
  CUTIS_TRY(radius, object.number("vessel_radius_mm", 0.0));
  return BloodOptics{oxygenation, radius};
}

Result<bool> hasOxygenation(const JsonValue& layer) {
  if (!layer.has("blood")) return false;
  CUTIS_TRY(object, layer.object("blood"));
  return object.has("oxygenation");
}

Status parseBlood(const JsonValue& root, Profile& profile) {
  CUTIS_TRY(absorption, root.object("absorption"));
  CUTIS_TRY(epidermis, root.object("epidermis"));
  CUTIS_TRY(dermis, root.object("dermis"));
  CUTIS_TRY(epidermalOwn, hasOxygenation(epidermis));
  CUTIS_TRY(dermalOwn, hasOxygenation(dermis));
  double shared = 0.0;
  if (epidermalOwn && dermalOwn) {
    if (absorption.has("oxygenation")) {
      return absorption.error("oxygenation", "left out where both layers have their own");
    }
  } else {
    CUTIS_TRY(oxygenation, absorption.number("oxygenation"));
    if (oxygenation < 0.0 || oxygenation > 1.0) {
      return absorption.error("oxygenation", "between 0 and 1");
    }
    shared = oxygenation;
  }
  CUTIS_TRY(epidermal, parseLayerBlood(epidermis, shared));
  CUTIS_TRY(dermal, parseLayerBlood(dermis, shared));
  profile.epidermalBlood = epidermal;
  profile.dermalBlood = dermal;
  return {};
}

Status parseEpidermis(const JsonValue& root, Profile& profile) {
  CUTIS_TRY(epidermis, root.object("epidermis"));
  CUTIS_CHECK(epidermis.allowOnly({"thickness_mm", "water_fraction", "mie_scattering",
                                   "rayleigh_scattering", "blood", "ultraviolet"}));
  CUTIS_TRY(thickness, epidermis.number("thickness_mm"));
  CUTIS_TRY(water, epidermis.number("water_fraction"));
  CUTIS_TRY(scattering, parseScattering(epidermis));
  if (epidermis.has("ultraviolet")) {
    CUTIS_TRY(ultraviolet, epidermis.object("ultraviolet"));
    CUTIS_CHECK(ultraviolet.allowOnly({"amplitude", "origin_nm", "decay_nm"}));
    CUTIS_TRY(tail, parseTail(ultraviolet));
    profile.epidermalUltraviolet = tail;
  }
  profile.epidermalThicknessMm = thickness;
  profile.epidermalWater = water;
  profile.epidermalScatteringLaw = scattering;
  return {};
}

Status parseDermalScattering(const JsonValue& dermis, Profile& profile) {
  if (!dermis.has("mie_scattering") && !dermis.has("rayleigh_scattering")) {
    CUTIS_TRY(ratio, dermis.number("scattering_ratio"));
    profile.dermalScatteringRatio = ratio;
    return {};
  }
  if (dermis.has("scattering_ratio")) {
    return dermis.error("scattering_ratio", "left out where the dermis has scattering laws");
  }
  CUTIS_TRY(law, parseScattering(dermis));
  profile.dermalScatteringLaw = law;
  return {};
}

Status parseFat(const JsonValue& root, const JsonValue& dermis, Profile& profile) {
  CUTIS_TRY(absorption, root.object("absorption"));
  if (!dermis.has("fat_fraction") && !absorption.has("fat")) return {};
  CUTIS_TRY(fraction, dermis.number("fat_fraction"));
  CUTIS_TRY(fat, absorption.object("fat"));
  CUTIS_CHECK(fat.allowOnly({"peak", "centre_nm", "deviation_nm"}));
  CUTIS_TRY(peak, fat.number("peak"));
  CUTIS_TRY(centre, fat.number("centre_nm"));
  CUTIS_TRY(deviation, fat.number("deviation_nm"));
  profile.dermalFat = fraction;
  profile.fat = {peak, centre, deviation};
  return {};
}

Status parseDermis(const JsonValue& root, Profile& profile) {
  CUTIS_TRY(dermis, root.object("dermis"));
  CUTIS_CHECK(
      dermis.allowOnly({"water_fraction", "scattering_ratio", "mie_scattering",
                        "rayleigh_scattering", "blood", "baseline_factor", "fat_fraction"}));
  CUTIS_TRY(water, dermis.number("water_fraction"));
  CUTIS_TRY(factor, dermis.number("baseline_factor", 1.0));
  CUTIS_CHECK(parseDermalScattering(dermis, profile));
  profile.dermalWater = water;
  profile.dermalBaselineFactor = factor;
  return parseFat(root, dermis, profile);
}

Status parseOptics(const JsonValue& root, Profile& profile) {
  CUTIS_TRY(index, root.number("refractive_index"));
  CUTIS_TRY(optics, root.text("layer_optics"));
  if (optics != "diffusion" && optics != "adding-doubling") {
    return root.error("layer_optics", "\"diffusion\" or \"adding-doubling\"");
  }
  profile.refractiveIndex = index;
  profile.layerOptics =
      optics == "diffusion" ? LayerOpticsKind::diffusion : LayerOpticsKind::addingDoubling;
  return {};
}

// Whether a field is there, by its path: "epidermis.blood".
bool hasField(const JsonValue& object, const std::string& path) {
  const auto dot = path.find('.');
  if (dot == std::string::npos) return object.has(path);
  const auto inner = object.object(path.substr(0, dot));
  return inner && hasField(inner.value(), path.substr(dot + 1));
}

// They are for readers of the file; only their form is checked.
Status checkSources(const JsonValue& root) {
  if (!root.has("sources")) return {};
  CUTIS_TRY(sources, root.object("sources"));
  for (const std::string& field : sources.keys()) {
    CUTIS_TRY(source, sources.text(field));
    if (source.empty()) return sources.error(field, "a text that is not empty");
    if (!hasField(root, field)) return sources.error(field, "the source of a field of the profile");
  }
  return {};
}

std::string builtInName(const std::string& name) {
  return "profiles/" + name + ".json";
}

}  // namespace

std::vector<std::string> profileNames() {
  return resourceStems("profiles", ".json");
}

Result<std::string> profileText(const std::string& nameOrPath, const std::string& place) {
  if (const auto text = resource(builtInName(nameOrPath))) return std::string(*text);
  const bool isPath = nameOrPath.find('/') != std::string::npos || nameOrPath.ends_with(".json");
  if (!isPath) {
    return inputError(place, "unknown profile " + inQuotes(nameOrPath) + "; " +
                                 suggestName(nameOrPath, profileNames()) + ", or name a JSON file");
  }
  return readTextFile(nameOrPath);
}

Result<Profile> loadProfile(const std::string& nameOrPath, const std::string& place) {
  CUTIS_TRY(text, profileText(nameOrPath, place));
  return parseProfile(text, nameOrPath);
}

Result<Profile> parseProfile(std::string_view text, const std::string& place) {
  CUTIS_TRY(root, parseJson(text, place));
  CUTIS_CHECK(checkVersion(root, "cutis_profile", kNewestProfile));
  CUTIS_CHECK(root.allowOnly({"cutis_profile", "name", "description", "parameters", "absorption",
                              "epidermis", "dermis", "refractive_index", "layer_optics", "prior",
                              "discrepancy", "sources"}));
  Profile profile;
  CUTIS_TRY(name, root.text("name"));
  CUTIS_TRY(description, root.text("description", ""));
  profile.name = name;
  profile.description = description;
  CUTIS_CHECK(parseParameters(root, profile));
  CUTIS_CHECK(parseAbsorption(root, profile));
  CUTIS_CHECK(parseBlood(root, profile));
  CUTIS_CHECK(parseEpidermis(root, profile));
  CUTIS_CHECK(parseDermis(root, profile));
  CUTIS_CHECK(parseOptics(root, profile));
  CUTIS_CHECK(checkSources(root));
  CUTIS_TRY(priorObject, root.object("prior"));
  CUTIS_TRY(prior, parsePrior(priorObject));
  profile.prior = prior;
  CUTIS_TRY(discrepancies, parseDiscrepancies(root));
  profile.discrepancies = discrepancies;
  CUTIS_CHECK(validate(profile, place));
  return profile;
}

}  // namespace cutis
