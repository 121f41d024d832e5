#include "src/files/profiles/calibration_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/base/echoed_text.h"
#include "core/skin/profile/discrepancy.h"
#include "src/files/io/json_file.h"
#include "src/files/io/suggestion.h"
#include "src/files/io/text_file.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/resources.h"

namespace cutis {
namespace {

constexpr int kNewestCalibration = 1;
constexpr char kFolder[] = "calibrations";
constexpr char kSpecularShare[] = "specular_share";
constexpr std::array<std::pair<const char*, SpecularPart>, 3> kSpecularParts = {
    {{"included", SpecularPart::included},
     {"excluded", SpecularPart::excluded},
     {"crossed", SpecularPart::crossPolarised}}};

// Beyond any spectrum, aperture and constant; sums of squares of these stay finite.
constexpr double kMostRadiusMm = 1000.0, kMostConstant = 1e12, kMostPull = 1e6;
constexpr char kWavelengthDemand[] = "between 300 and 1000";

bool isWavelength(double nm) {
  return nm >= kFirstWavelengthNm && nm <= kLastWavelengthNm;
}

// Whether it can be an error of reflectance.
bool isShareAbove0(double value) {
  return value > 0.0 && value <= 1.0;
}

Result<SpecularPart> parseSpecular(const JsonValue& object) {
  CUTIS_TRY(text, object.text("specular"));
  for (const auto& [name, part] : kSpecularParts) {
    if (text == name) return part;
  }
  return object.error("specular", "\"included\", \"excluded\" or \"crossed\"");
}

Result<SpectralAim> parseAim(const JsonValue& object) {
  CUTIS_CHECK(object.allowOnly({"from_nm", "to_nm", "rms"}));
  CUTIS_TRY(from, object.number("from_nm"));
  CUTIS_TRY(to, object.number("to_nm"));
  CUTIS_TRY(rms, object.number("rms"));
  if (!isWavelength(from)) return object.error("from_nm", kWavelengthDemand);
  if (!isWavelength(to)) return object.error("to_nm", kWavelengthDemand);
  if (!(from < to)) return object.error("to_nm", "greater than from_nm");
  if (!isShareAbove0(rms)) return object.error("rms", "greater than 0 and at most 1");
  return SpectralAim{from, to, rms};
}

// How a set was measured, aims aside.
Result<CalibrationSpectra> parseMeasurement(const JsonValue& object) {
  CalibrationSpectra spectra;
  CUTIS_TRY(name, object.text("name"));
  CUTIS_TRY(specular, parseSpecular(object));
  CUTIS_TRY(share, object.number(kSpecularShare, kSkinSpecularShare));
  if (share < 0.0 || share >= 1.0) return object.error(kSpecularShare, "0 or more and below 1");
  if (object.has("aperture_radius_mm")) {
    CUTIS_TRY(radius, object.number("aperture_radius_mm"));
    if (!(radius > 0.0 && radius <= kMostRadiusMm)) {
      return object.error("aperture_radius_mm", "greater than 0 and at most 1000");
    }
    spectra.edgeLossPerMm = edgeLossOfAperture(radius);
  }
  spectra.name = name;
  spectra.specular = specular;
  spectra.specularShare = share;
  return spectra;
}

Result<CalibrationSpectra> parseSpectra(const JsonValue& object) {
  CUTIS_CHECK(object.allowOnly({"name", "specular", kSpecularShare, "aperture_radius_mm", "aims"}));
  CUTIS_TRY(spectra, parseMeasurement(object));
  CUTIS_TRY(aims, object.array("aims"));
  for (const JsonValue& each : aims) {
    CUTIS_TRY(aim, parseAim(each));
    spectra.aims.push_back(aim);
  }
  if (spectra.aims.empty()) return object.error("aims", "one aim or more");
  return spectra;
}

Result<std::size_t> findSpectra(const JsonValue& object, const CalibrationRecipe& recipe) {
  CUTIS_TRY(name, object.text("spectra"));
  const auto found = std::find_if(recipe.spectra.begin(), recipe.spectra.end(),
                                  [&](const auto& spectra) { return spectra.name == name; });
  if (found != recipe.spectra.end()) {
    return static_cast<std::size_t>(found - recipe.spectra.begin());
  }
  return object.error("spectra", "the name of one of the spectra");
}

Result<CalibrationConstant> parseConstant(const JsonValue& object,
                                          const CalibrationRecipe& recipe) {
  CUTIS_CHECK(
      object.allowOnly({"field", "spectra", "low", "high", "expected", "sd", "scale", "note"}));
  CalibrationConstant result;
  CUTIS_TRY(field, object.text("field"));
  CUTIS_TRY(low, object.number("low"));
  CUTIS_TRY(high, object.number("high"));
  CUTIS_TRY(expected, object.number("expected"));
  CUTIS_TRY(deviation, object.number("sd"));
  CUTIS_TRY(scale, object.text("scale", "linear"));
  CUTIS_TRY(note, object.text("note", ""));
  for (const char* name : {"low", "high", "expected", "sd"}) {
    CUTIS_TRY(number, object.number(name));
    if (std::abs(number) > kMostConstant) return object.error(name, "at most 1e12");
  }
  if (!(low < high)) return object.error("high", "greater than low");
  if (!(deviation > 0.0)) return object.error("sd", "greater than 0");
  if (scale != "linear" && scale != "log") return object.error("scale", "\"linear\" or \"log\"");
  const bool isLog = scale == "log";
  if (isLog && !(low > 0.0)) return object.error("low", "greater than 0 on the log scale");
  if (isLog && !(expected > 0.0)) {
    return object.error("expected", "greater than 0 on the log scale");
  }
  if (object.has("spectra")) {
    if (field != kSpecularShare) {
      return object.error("field", "specular_share where the constant is of spectra");
    }
    CUTIS_TRY(spectra, findSpectra(object, recipe));
    if (low < 0.0 || high >= 1.0) return object.error("high", "below 1, and low 0 or more");
    result.spectra = spectra;
  }
  result.constant = {field, low, high, expected, deviation, isLog};
  result.note = note;
  return result;
}

Status parsePriorSource(const JsonValue& root, CalibrationRecipe& recipe) {
  CUTIS_TRY(object, root.object("prior"));
  CUTIS_CHECK(object.allowOnly({"spectra", "noise"}));
  CUTIS_TRY(spectra, findSpectra(object, recipe));
  CUTIS_TRY(noise, object.number("noise"));
  if (!isShareAbove0(noise)) return object.error("noise", "greater than 0 and at most 1");
  recipe.priorSpectra = spectra;
  recipe.priorNoise = noise;
  return {};
}

// Text of the profile to begin from: a file beside the recipe, or a built-in profile.
Result<std::string> startText(const std::string& start, const std::string& place, bool isBuiltIn) {
  namespace fs = std::filesystem;
  if (isBuiltIn) {
    const std::string beside = std::string(kFolder) + "/" + start;
    if (const auto text = resource(beside)) return std::string(*text);
  }
  const bool isBeside = start.ends_with(".json") && fs::path(start).is_relative();
  return profileText(isBeside ? (fs::path(place).parent_path() / start).string() : start, place);
}

Status parseNames(const JsonValue& root, CalibrationRecipe& recipe) {
  CUTIS_TRY(name, root.text("name"));
  CUTIS_TRY(description, root.text("description", ""));
  CUTIS_TRY(start, root.text("start"));
  if (name.empty()) return root.error("name", "a text that is not empty");
  recipe.name = name;
  recipe.description = description;
  recipe.start = start;
  return {};
}

Status parseConstants(const JsonValue& root, CalibrationRecipe& recipe) {
  CUTIS_TRY(step, root.integer("step_nm"));
  CUTIS_TRY(pull, root.number("pull"));
  if (step <= 0 || step % kWavelengthStepNm != 0 || step > 100) {
    return root.error("step_nm", "an even number from 2 to 100");
  }
  if (!(pull >= 0.0 && pull <= kMostPull)) return root.error("pull", "between 0 and a million");
  recipe.stepNm = step;
  recipe.pull = pull;
  CUTIS_TRY(spectra, root.array("spectra"));
  for (const JsonValue& each : spectra) {
    CUTIS_TRY(parsed, parseSpectra(each));
    for (const CalibrationSpectra& other : recipe.spectra) {
      if (other.name == parsed.name) return each.error("name", "different from that of others");
    }
    recipe.spectra.push_back(parsed);
  }
  if (recipe.spectra.empty()) return root.error("spectra", "one object or more");
  CUTIS_CHECK(parsePriorSource(root, recipe));
  CUTIS_TRY(constants, root.array("constants"));
  for (const JsonValue& each : constants) {
    CUTIS_TRY(parsed, parseConstant(each, recipe));
    for (const CalibrationConstant& other : recipe.constants) {
      if (other.constant.name == parsed.constant.name && other.spectra == parsed.spectra) {
        return each.error("field", "named once");
      }
    }
    recipe.constants.push_back(parsed);
  }
  if (recipe.constants.empty()) return root.error("constants", "one object or more");
  return {};
}

// Reads what a recipe asks that keeps all constants.
Status parseDiscrepancyAsked(const JsonValue& root, CalibrationRecipe& recipe) {
  CUTIS_TRY(spectra, root.array("spectra"));
  if (spectra.size() != 1) {
    return root.error("spectra", "one object where a discrepancy is learned");
  }
  CUTIS_CHECK(spectra[0].allowOnly({"name", "specular", kSpecularShare, "aperture_radius_mm"}));
  CUTIS_TRY(parsed, parseMeasurement(spectra[0]));
  recipe.spectra.push_back(parsed);
  CUTIS_TRY(object, root.object("discrepancy"));
  CUTIS_CHECK(object.allowOnly({"components"}));
  CUTIS_TRY(components, object.integer("components"));
  if (components < 1 || components > kMaximumCoefficients) {
    return object.error("components", "1 to " + std::to_string(kMaximumCoefficients));
  }
  recipe.components = components;
  return {};
}

Result<CalibrationRecipe> parseRecipe(std::string_view text, const std::string& place,
                                      bool isBuiltIn) {
  CUTIS_TRY(root, parseJson(text, place));
  CUTIS_CHECK(checkVersion(root, "cutis_calibration", kNewestCalibration));
  CalibrationRecipe recipe;
  if (root.has("discrepancy")) {
    CUTIS_CHECK(root.allowOnly(
        {"cutis_calibration", "name", "description", "start", "spectra", "discrepancy"}));
    CUTIS_CHECK(parseNames(root, recipe));
    CUTIS_CHECK(parseDiscrepancyAsked(root, recipe));
  } else {
    CUTIS_CHECK(root.allowOnly({"cutis_calibration", "name", "description", "start", "step_nm",
                                "pull", "spectra", "prior", "constants"}));
    CUTIS_CHECK(parseNames(root, recipe));
    CUTIS_CHECK(parseConstants(root, recipe));
  }
  CUTIS_TRY(profile, startText(recipe.start, place, isBuiltIn));
  CUTIS_CHECK(parseProfile(profile, recipe.start));
  recipe.startText = profile;
  return recipe;
}

}  // namespace

Result<CalibrationRecipe> loadCalibrationRecipe(const std::string& nameOrPath,
                                                const std::string& place) {
  const std::string builtIn = std::string(kFolder) + "/" + nameOrPath + ".json";
  if (const auto text = resource(builtIn)) return parseRecipe(*text, nameOrPath, true);
  const bool isPath = nameOrPath.find('/') != std::string::npos || nameOrPath.ends_with(".json");
  if (!isPath) {
    return inputError(place, "unknown calibration " + inQuotes(nameOrPath) + "; " +
                                 suggestName(nameOrPath, resourceStems(kFolder, ".json")) +
                                 ", or name a JSON file");
  }
  CUTIS_TRY(text, readTextFile(nameOrPath));
  return parseRecipe(text, nameOrPath, false);
}

}  // namespace cutis
