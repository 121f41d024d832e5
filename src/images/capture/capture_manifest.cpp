#include "src/images/capture/capture_manifest.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/choice_place.h"
#include "core/base/echoed_text.h"
#include "src/files/io/json_file.h"
#include "src/files/io/suggestion.h"
#include "src/files/rig_file.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

Result<fs::path> findManifest(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return path;
  std::error_code error;
  if (fs::exists(path / kCaptureFile, error)) return path / kCaptureFile;
  if (error == std::errc::permission_denied) {
    return inputError(path.string(), "this folder may not be entered; check its permissions");
  }
  return inputError(path.string(),
                    std::string("there is no ") + kCaptureFile +
                        " in this folder; choose a folder that has one, or an image");
}

// A name in capture.json may not lead out of its folder, neither by itself nor through links.
Result<fs::path> resolveInside(const fs::path& folder, const JsonValue& object,
                               const std::string& key) {
  CUTIS_TRY(name, object.text(key));
  const auto outside = [&] {
    return object.error(key, "a file in or below the folder of the capture, not " + inQuotes(name));
  };
  const fs::path relative(name);
  const bool climbs = std::find(relative.begin(), relative.end(), "..") != relative.end();
  if (name.empty() || relative.has_root_path() || climbs) return outside();
  std::error_code error;
  const fs::path root = fs::weakly_canonical(folder.empty() ? "." : folder, error);
  const fs::path file = error ? fs::path() : fs::weakly_canonical(folder / relative, error);
  if (error) return outside();
  const auto [rootEnd, ignored] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
  if (rootEnd != root.end()) return outside();
  return folder / relative;
}

Result<std::array<float, 3>> parseScale(const JsonValue& object) {
  std::array<float, 3> scale = {1.0f, 1.0f, 1.0f};
  if (!object.has("scale")) return scale;
  CUTIS_TRY(factors, object.array("scale"));
  if (factors.size() != scale.size()) return object.error("scale", "a list of three numbers");
  for (std::size_t c = 0; c < scale.size(); ++c) {
    CUTIS_TRY(factor, factors[c].asNumber());
    if (!(factor > 0.0) || factor > 1e6) return factors[c].error("positive, at most 1e6");
    scale[c] = static_cast<float>(factor);
  }
  return scale;
}

std::vector<std::string> lightNamesOf(const Rig& rig) {
  std::vector<std::string> names;
  for (const RigLight& light : rig.lights)
    names.push_back(light.name);
  return names;
}

Result<CapturePhotograph> parsePhotograph(const JsonValue& object, const fs::path& folder,
                                          const Rig& rig) {
  if (!object.isObject()) return object.error("an object with a light and a file");
  CUTIS_CHECK(object.allowOnly({"light", "file", "scale"}));
  CapturePhotograph photograph;
  CUTIS_TRY(light, object.text("light"));
  photograph.light = rig.lightIndex(light);
  if (photograph.light < 0) {
    return object.error("light", "a light of rig " + inQuotes(rig.name) + ", not " +
                                     inQuotes(light) + "; " +
                                     suggestName(light, lightNamesOf(rig)));
  }
  CUTIS_TRY(path, resolveInside(folder, object, "file"));
  CUTIS_TRY(file, object.text("file"));
  CUTIS_TRY(scale, parseScale(object));
  photograph.path = path;
  photograph.file = file;
  photograph.scale = scale;
  return photograph;
}

// Each light of the rig at most once, in the order of the rig.
Result<std::vector<CapturePhotograph>> parsePhotographs(const JsonValue& root,
                                                        const fs::path& folder, const Rig& rig) {
  CUTIS_TRY(images, root.array("images"));
  if (images.empty()) return root.error("images", "a list of at least one image");
  std::vector<CapturePhotograph> photographs;
  for (const JsonValue& object : images) {
    CUTIS_TRY(photograph, parsePhotograph(object, folder, rig));
    for (const CapturePhotograph& other : photographs) {
      if (other.light == photograph.light) {
        return object.error("light", "named by one image only; keep " + inQuotes(other.file) +
                                         " or " + inQuotes(photograph.file));
      }
    }
    photographs.push_back(photograph);
  }
  std::sort(photographs.begin(), photographs.end(),
            [](const auto& a, const auto& b) { return a.light < b.light; });
  return photographs;
}

Result<Rig> rigOf(const JsonValue& root, const fs::path& folder, const std::string& other,
                  const Notice& notice) {
  if (!other.empty()) return loadRig(other, {}, kRigChoice, notice);
  CUTIS_TRY(name, root.text("rig"));
  return loadRig(name, folder.string(), root.file() + ": rig", notice);
}

constexpr char kEncoding[] = "encoding";

// The curve of a colour space is undone; its primaries do not count, since channels are the
// camera's own.
Result<CaptureEncoding> parseEncoding(const JsonValue& root) {
  CaptureEncoding encoding;
  CUTIS_TRY(name, root.text(kEncoding));
  CUTIS_TRY(version, root.integer("cutis_capture"));
  encoding.name = name;
  if (name == "linear") return encoding;
  if (version < 2) {
    return root.error(kEncoding,
                      "\"linear\"; for the name of a colour space set cutis_capture to 2");
  }
  encoding.isRaw = name == "raw";
  if (encoding.isRaw) return encoding;
  CUTIS_TRY(space, namedColorSpace(name, root.file() + ": " + kEncoding));
  if (!space.matrix) {
    return root.error(kEncoding, "\"linear\", \"raw\" or a colour space of curves and primaries");
  }
  encoding.name = space.name;
  encoding.curves = space.matrix->curves;
  return encoding;
}

// Leaves the lights asked for, which must have photographs.
Status keepLights(const std::vector<std::string>& wanted, CaptureManifest& manifest) {
  std::vector<std::string> there;
  for (const CapturePhotograph& photograph : manifest.photographs) {
    there.push_back(manifest.rig.lights[static_cast<std::size_t>(photograph.light)].name);
  }
  manifest.lights = there;
  for (const std::string& name : wanted) {
    if (std::find(there.begin(), there.end(), name) == there.end()) {
      return inputError(kLightsChoice, "the capture has no photograph under " + inQuotes(name) +
                                           "; " + suggestName(name, there));
    }
  }
  std::vector<CapturePhotograph> kept;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < there.size(); ++i) {
    const bool asked = std::find(wanted.begin(), wanted.end(), there[i]) != wanted.end();
    if (!wanted.empty() && !asked) continue;
    kept.push_back(manifest.photographs[i]);
    kept.back().light = static_cast<int>(names.size());
    names.push_back(there[i]);
  }
  CUTIS_TRY(rig, withLights(manifest.rig, names, kLightsChoice));
  manifest.rig = std::move(rig);
  manifest.photographs = std::move(kept);
  return {};
}

}  // namespace

bool CaptureEncoding::isLinear() const {
  return std::all_of(curves.begin(), curves.end(),
                     [](const TransferCurve& curve) { return curve.isLinear(); });
}

Result<CaptureManifest> readCaptureManifest(const fs::path& path, const CaptureReadOptions& options,
                                            const Notice& notice) {
  CUTIS_TRY(file, findManifest(path));
  const fs::path folder = file.parent_path();
  CUTIS_TRY(root, readJson(file));
  CUTIS_CHECK(checkVersion(root, "cutis_capture", kNewestCaptureVersion));
  CUTIS_CHECK(root.allowOnly(
      {"cutis_capture", "rig", "encoding", "images", "mask", "chart", "description", "simulated"}));
  if (root.has("chart")) {
    return inputError(root.file(), "chart: charts are not supported by this version; use scale");
  }
  CUTIS_TRY(encoding, parseEncoding(root));
  CaptureManifest manifest;
  manifest.encoding = std::move(encoding);
  CUTIS_TRY(rig, rigOf(root, folder, options.rig, notice));
  manifest.rig = std::move(rig);
  CUTIS_TRY(photographs, parsePhotographs(root, folder, manifest.rig));
  manifest.photographs = std::move(photographs);
  CUTIS_CHECK(keepLights(options.lights, manifest));
  if (root.has("mask")) {
    CUTIS_TRY(mask, resolveInside(folder, root, "mask"));
    manifest.mask = mask;
  }
  if (!options.mask.empty()) manifest.mask = options.mask;
  CUTIS_TRY(simulated, root.boolean("simulated", false));
  manifest.isSimulated = simulated;
  return manifest;
}

}  // namespace cutis
