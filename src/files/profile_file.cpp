#include "src/files/profile_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "src/files/resources.h"
#include "src/files/spectral_library.h"
#include "src/files/suggestion.h"
#include "src/files/text_file.h"

namespace cutis {
namespace {

constexpr int kNewestVersion = 1;
constexpr std::array<std::string_view, 3> kSpacings = {"uniform", "quadratic", "cubic"};

Result<PowerLaw> parsePowerLaw(const JsonValue& parent, const std::string& key) {
  CUTIS_TRY(object, parent.object(key));
  CUTIS_CHECK(object.allowOnly({"coefficient", "exponent"}));
  CUTIS_TRY(coefficient, object.number("coefficient"));
  CUTIS_TRY(exponent, object.number("exponent"));
  return PowerLaw{coefficient, exponent};
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
  CUTIS_CHECK(parameters.allowOnly({"melanin", "melanin_blend", "haemoglobin_dermal",
                                    "haemoglobin_epidermal", "carotene"}));
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

Status parseAbsorption(const JsonValue& root, Profile& profile) {
  CUTIS_TRY(absorption, root.object("absorption"));
  CUTIS_CHECK(absorption.allowOnly(
      {"chromophores", "eumelanin", "pheomelanin", "baseline", "oxygenation"}));
  CUTIS_TRY(eumelanin, parsePowerLaw(absorption, "eumelanin"));
  CUTIS_TRY(pheomelanin, parsePowerLaw(absorption, "pheomelanin"));
  CUTIS_TRY(baseline, absorption.object("baseline"));
  CUTIS_CHECK(baseline.allowOnly({"constant", "amplitude", "origin_nm", "decay_nm"}));
  CUTIS_TRY(constant, baseline.number("constant"));
  CUTIS_TRY(amplitude, baseline.number("amplitude"));
  CUTIS_TRY(origin, baseline.number("origin_nm"));
  CUTIS_TRY(decay, baseline.number("decay_nm"));
  CUTIS_TRY(oxygenation, absorption.number("oxygenation"));
  profile.eumelanin = eumelanin;
  profile.pheomelanin = pheomelanin;
  profile.baseline = {constant, amplitude, origin, decay};
  profile.oxygenation = oxygenation;
  return parseChromophores(absorption, profile);
}

Status parseLayers(const JsonValue& root, Profile& profile) {
  CUTIS_TRY(epidermis, root.object("epidermis"));
  CUTIS_CHECK(epidermis.allowOnly(
      {"thickness_mm", "water_fraction", "mie_scattering", "rayleigh_scattering"}));
  CUTIS_TRY(thickness, epidermis.number("thickness_mm"));
  CUTIS_TRY(epidermalWater, epidermis.number("water_fraction"));
  CUTIS_TRY(mie, parsePowerLaw(epidermis, "mie_scattering"));
  CUTIS_TRY(rayleigh, parsePowerLaw(epidermis, "rayleigh_scattering"));
  CUTIS_TRY(dermis, root.object("dermis"));
  CUTIS_CHECK(dermis.allowOnly({"water_fraction", "scattering_ratio"}));
  CUTIS_TRY(dermalWater, dermis.number("water_fraction"));
  CUTIS_TRY(ratio, dermis.number("scattering_ratio"));
  CUTIS_TRY(index, root.number("refractive_index"));
  CUTIS_TRY(optics, root.text("layer_optics"));
  if (optics != "diffusion") return root.error("layer_optics", "\"diffusion\"");
  profile.epidermalThicknessMm = thickness;
  profile.epidermalWater = epidermalWater;
  profile.mieScattering = mie;
  profile.rayleighScattering = rayleigh;
  profile.dermalWater = dermalWater;
  profile.dermalScatteringRatio = ratio;
  profile.refractiveIndex = index;
  profile.layerOptics = LayerOpticsKind::diffusion;
  return {};
}

// One of "mean", "sd" of a prior.
Status parsePriorPart(const JsonValue& prior, const std::string& key, const Prior* base,
                      ParameterVector& values) {
  if (base != nullptr && !prior.has(key)) return {};
  CUTIS_TRY(part, prior.object(key));
  CUTIS_CHECK(part.allowOnly({"melanin", "melanin_blend", "haemoglobin_dermal",
                              "haemoglobin_epidermal", "carotene"}));
  for (const Parameter parameter : kParameters) {
    const std::string name(parameterName(parameter));
    if (base != nullptr && !part.has(name)) continue;
    CUTIS_TRY(value, part.number(name));
    values[parameter] = value;
  }
  return {};
}

std::string builtInName(const std::string& name) { return "profiles/" + name + ".json"; }

}  // namespace

std::vector<std::string> profileNames() { return resourceStems("profiles", ".json"); }

Result<std::string> profileText(const std::string& nameOrPath, const std::string& place) {
  if (const auto text = resource(builtInName(nameOrPath))) return std::string(*text);
  const bool isPath = nameOrPath.find('/') != std::string::npos || nameOrPath.ends_with(".json");
  if (!isPath) {
    return inputError(place, "unknown profile '" + nameOrPath + "'; " +
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
  CUTIS_CHECK(checkVersion(root, "cutis_profile", kNewestVersion));
  CUTIS_CHECK(root.allowOnly({"cutis_profile", "name", "description", "parameters", "absorption",
                              "epidermis", "dermis", "refractive_index", "layer_optics", "prior"}));
  Profile profile;
  CUTIS_TRY(name, root.text("name"));
  CUTIS_TRY(description, root.text("description", ""));
  profile.name = name;
  profile.description = description;
  CUTIS_CHECK(parseParameters(root, profile));
  CUTIS_CHECK(parseAbsorption(root, profile));
  CUTIS_CHECK(parseLayers(root, profile));
  CUTIS_TRY(priorObject, root.object("prior"));
  CUTIS_TRY(prior, parsePrior(priorObject, nullptr));
  profile.prior = prior;
  CUTIS_CHECK(validate(profile, place));
  return profile;
}

Result<Prior> parsePrior(const JsonValue& object, const Prior* base) {
  CUTIS_CHECK(object.allowOnly({"scale", "mean", "sd"}));
  Prior prior = base != nullptr ? *base : Prior();
  CUTIS_TRY(scale, object.text("scale"));
  if (scale != "linear" && scale != "log") return object.error("scale", "\"linear\" or \"log\"");
  prior.scale = scale == "log" ? PriorScale::log : PriorScale::linear;
  CUTIS_CHECK(parsePriorPart(object, "mean", base, prior.mean));
  CUTIS_CHECK(parsePriorPart(object, "sd", base, prior.deviation));
  for (const Parameter parameter : kParameters) {
    const std::string field(parameterName(parameter));
    if (!(prior.deviation[parameter] > 0.0)) return object.error("sd." + field, "positive");
    if (prior.isLog(parameter) && !(prior.mean[parameter] > 0.0)) {
      return object.error("mean." + field, "positive on the log scale");
    }
  }
  return prior;
}

Result<Prior> readPrior(const std::string& path, const Prior& base) {
  CUTIS_TRY(root, readJson(path));
  CUTIS_TRY(scale, root.text("scale", base.scale == PriorScale::log ? "log" : "linear"));
  // Numbers of one scale mean nothing on the other.
  const bool sameScale = (scale == "log") == (base.scale == PriorScale::log);
  return parsePrior(root, sameScale ? &base : nullptr);
}

}  // namespace cutis
