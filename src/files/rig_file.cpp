#include "src/files/rig_file.h"

#include <array>
#include <filesystem>
#include <optional>

#include "core/base/echoed_text.h"
#include "src/files/io/json_file.h"
#include "src/files/io/suggestion.h"
#include "src/files/resources.h"
#include "src/files/spectral_library.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr int kNewestRig = 1;
constexpr std::array<const char*, 3> kPrimaryNames = {"R", "G", "B"};

// Only ratios of a mix count; beyond these they are lost in rounding.
constexpr double kLeastShare = 1e-6, kMostShare = 1e6;

using Primaries = std::optional<std::array<Spectrum, 3>>;

Result<RigLight> parseLight(const JsonValue& object, const fs::path& folder,
                            const Primaries& primaries, const Notice& notice) {
  CUTIS_CHECK(object.allowOnly({"name", "mix", "spectrum"}));
  RigLight light;
  CUTIS_TRY(name, object.text("name"));
  light.name = name;
  if (object.has("mix") == object.has("spectrum")) {
    return object.error("mix", "given, or spectrum, and not both");
  }
  if (object.has("spectrum")) {
    CUTIS_TRY(reference, object.text("spectrum"));
    CUTIS_TRY(power, loadLight({reference, folder, object.file(), notice}));
    light.power = power;
    return light;
  }
  if (!primaries) return object.error("mix", "left out unless the rig names primaries");
  CUTIS_TRY(mix, object.object("mix"));
  CUTIS_CHECK(mix.allowOnly({"R", "G", "B"}));
  light.mix = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const auto index = static_cast<std::size_t>(k);
    CUTIS_TRY(share, mix.number(kPrimaryNames[index], 0.0));
    if (share != 0.0 && !(share >= kLeastShare && share <= kMostShare)) {
      return mix.error(kPrimaryNames[index], "zero or positive, from 1e-6 to 1e6");
    }
    (*light.mix)[k] = share;
    light.power += share * (*primaries)[index];
  }
  return light;
}

Result<NoiseModel> parseNoise(const JsonValue& root) {
  NoiseModel noise;
  if (!root.has("noise")) return noise;
  CUTIS_TRY(object, root.object("noise"));
  CUTIS_CHECK(object.allowOnly({"read", "proportional"}));
  CUTIS_TRY(read, object.number("read"));
  CUTIS_TRY(proportional, object.number("proportional"));
  return NoiseModel{read, proportional};
}

Result<Rig> parseRig(const JsonValue& root, const fs::path& folder, const Notice& notice) {
  CUTIS_CHECK(checkVersion(root, "cutis_rig", kNewestRig));
  CUTIS_CHECK(root.allowOnly(
      {"cutis_rig", "name", "description", "camera", "primaries", "lights", "noise"}));
  Rig rig;
  CUTIS_TRY(name, root.text("name"));
  rig.name = name;
  CUTIS_TRY(cameraObject, root.object("camera"));
  CUTIS_CHECK(cameraObject.allowOnly({"sensitivity"}));
  CUTIS_TRY(sensitivity, cameraObject.text("sensitivity"));
  CUTIS_TRY(camera, loadCamera({sensitivity, folder, root.file(), notice}));
  rig.camera = camera;
  Primaries primaries;
  if (root.has("primaries")) {
    CUTIS_TRY(object, root.object("primaries"));
    CUTIS_CHECK(object.allowOnly({"file"}));
    CUTIS_TRY(file, object.text("file"));
    CUTIS_TRY(loaded, loadPrimaries({file, folder, root.file(), notice}));
    primaries = loaded;
  }
  CUTIS_TRY(lights, root.array("lights"));
  for (const JsonValue& object : lights) {
    if (!object.isObject()) return object.error("an object with a name and a mix or spectrum");
    CUTIS_TRY(light, parseLight(object, folder, primaries, notice));
    rig.lights.push_back(std::move(light));
  }
  CUTIS_TRY(noise, parseNoise(root));
  rig.noise = noise;
  CUTIS_CHECK(validate(rig, root.file()));
  return rig;
}

}  // namespace

std::vector<std::string> rigNames() {
  return resourceStems("rigs", ".json");
}

Result<Rig> loadRig(const std::string& nameOrPath, const std::string& folder,
                    const std::string& place, const Notice& notice) {
  if (const auto text = resource("rigs/" + nameOrPath + ".json")) {
    CUTIS_TRY(root, parseJson(*text, "built-in rig " + nameOrPath));
    return parseRig(root, {}, notice);
  }
  if (nameOrPath.find('/') == std::string::npos && !nameOrPath.ends_with(".json")) {
    return inputError(place, "unknown rig " + inQuotes(nameOrPath) + "; " +
                                 suggestName(nameOrPath, rigNames()) + ", or name a JSON file");
  }
  const fs::path path = fs::path(folder) / nameOrPath;
  CUTIS_TRY(root, readJson(path));
  CUTIS_TRY(rig, parseRig(root, path.parent_path(), notice));
  rig.file = path.string();
  return std::move(rig);
}

}  // namespace cutis
