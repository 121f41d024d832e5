#include "src/app/project/manifest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "src/app/fit_method.h"
#include "src/app/project/pins_json.h"
#include "src/files/edits/edits_file.h"
#include "src/files/io/file_extension.h"
#include "src/files/io/json_file.h"
#include "src/files/io/text_file.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/rig_file.h"
#include "src/files/spectral_library.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr char kOxygenationName[] = "oxygenation";
constexpr char kThicknessName[] = "thickness";
constexpr char kVersion[] = "cutis_project";
constexpr char kAutomatic[] = "auto";

constexpr std::array<std::pair<const char*, SourceKind>, 4> kKinds = {
    {{"sample", SourceKind::sample},
     {"image", SourceKind::image},
     {"capture", SourceKind::capture},
     {"maps", SourceKind::maps}}};

constexpr std::array<std::pair<const char*, SpecularPart>, 3> kSpecularParts = {
    {{"included", SpecularPart::included},
     {"excluded", SpecularPart::excluded},
     {"cross-polarised", SpecularPart::crossPolarised}}};

const char* kindName(SourceKind kind) {
  return std::find_if(kKinds.begin(), kKinds.end(),
                      [&](const auto& row) { return row.second == kind; })
      ->first;
}

bool isAmong(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Lights, observers and cameras are named alike.
std::vector<std::string> spectralNames() {
  std::vector<std::string> names = lightNames();
  for (const auto& further : {observerNames(), cameraNames()})
    names.insert(names.end(), further.begin(), further.end());
  return names;
}

// Paths as the manifest in a folder names them, and back.
class PathNames {
 public:
  explicit PathNames(fs::path folder) : folder_(std::move(folder)) {}

  std::string nameOf(const fs::path& path) const {
    if (path.empty() || folder_.empty()) return path.generic_string();
    return path.lexically_proximate(folder_).generic_string();
  }
  // Built-in names stand for themselves.
  std::string nameOf(const std::string& nameOrPath, const std::vector<std::string>& known) const {
    if (nameOrPath.empty() || isAmong(nameOrPath, known)) return nameOrPath;
    return nameOf(fs::absolute(nameOrPath).lexically_normal());
  }
  fs::path pathOf(const std::string& name) const {
    return name.empty() ? fs::path() : (folder_ / name).lexically_normal();
  }
  std::string pathOf(const std::string& name, const std::vector<std::string>& known) const {
    return name.empty() || isAmong(name, known) ? name : pathOf(name).string();
  }

 private:
  fs::path folder_;
};

Json sourceJson(const ProjectSource& source, const std::optional<double>& exposure,
                const PathNames& names) {
  Json json;
  json["kind"] = kindName(source.kind);
  if (source.kind == SourceKind::sample) return json;
  json["path"] = names.nameOf(source.path);
  json["files"] = Json::array();
  for (const SourceFile& file : source.files)
    json["files"].push_back({{"file", names.nameOf(file.path)}, {"hash", file.hash}});
  if (source.kind == SourceKind::maps) return json;
  const SourceOptions& options = source.options;
  json["rig"] = names.nameOf(options.rig, rigNames());
  json["lights"] = options.lights;
  json["mask"] = names.nameOf(options.mask);
  json["layer"] = options.layer;
  json["colorspace"] = options.colorSpace;
  json["exposure"] = exposure ? Json(*exposure) : Json(kAutomatic);
  return json;
}

// What is usual is not written.
Json fitJson(const FitChoice& fit, const PathNames& names) {
  Json json;
  json["profile"] = names.nameOf(fit.profile, profileNames());
  json["method"] = fitMethodName(fit.method);
  json["shading"] = fit.shading;
  if (fit.noise) json["noise"] = *fit.noise;
  if (!fit.prior.empty()) json["prior"] = names.nameOf(fs::path(fit.prior));
  for (const Parameter k : kParameters) {
    const auto& held = fit.fixed[static_cast<std::size_t>(k)];
    if (held) json["fixed"][std::string(parameterName(k))] = *held;
  }
  if (fit.free.oxygenation) json["free"].push_back(kOxygenationName);
  if (fit.free.thickness) json["free"].push_back(kThicknessName);
  if (fit.discrepancy) json["discrepancy"] = *fit.discrepancy;
  for (const auto& [name, part] : kSpecularParts) {
    if (fit.specular == part) json["specular"] = name;
  }
  if (fit.specular == SpecularPart::included) json["specular_share"] = fit.specularShare;
  return json;
}

Json viewJson(const ProjectView& view, const PathNames& names) {
  Json json;
  json["view"] = view.view;
  json["place"] = nullptr;
  if (view.place) json["place"] = {view.place->x, view.place->y, view.place->zoom};
  json["light"] = names.nameOf(view.light, spectralNames());
  json["observer"] = names.nameOf(view.observer, spectralNames());
  json["adaptation"] = view.adaptation;
  return json;
}

Status parseFiles(const JsonValue& object, const PathNames& names, const Notice& notice,
                  ProjectSource& source) {
  CUTIS_TRY(files, object.array("files"));
  for (const JsonValue& element : files) {
    if (!element.isObject()) return element.error("an object");
    CUTIS_TRY(file, element.text("file"));
    CUTIS_TRY(hash, element.text("hash"));
    element.sayUnknown({"file", "hash"}, notice);
    source.files.push_back({names.pathOf(file), hash});
  }
  return {};
}

Status parseExposure(const JsonValue& object, FitChoice& fit) {
  if (!object.has("exposure")) return {};
  const auto text = object.text("exposure");
  if (text && text.value() == kAutomatic) return {};
  const auto number = object.number("exposure");
  if (!number || !(number.value() > 0.0))
    return object.error("exposure", "\"auto\" or a number above 0");
  fit.exposure = number.value();
  return {};
}

Status parseOptions(const JsonValue& object, const PathNames& names, ProjectSource& source) {
  CUTIS_TRY(rig, object.text("rig", std::string()));
  CUTIS_TRY(mask, object.text("mask", std::string()));
  CUTIS_TRY(layer, object.text("layer", std::string()));
  CUTIS_TRY(colorSpace, object.text("colorspace", std::string()));
  CUTIS_TRY(lights, object.array("lights"));
  SourceOptions& options = source.options;
  options.rig = names.pathOf(rig, rigNames());
  options.mask = names.pathOf(mask);
  options.layer = layer;
  options.colorSpace = colorSpace;
  for (const JsonValue& element : lights) {
    CUTIS_TRY(light, element.asText());
    options.lights.push_back(light);
  }
  return {};
}

Result<ProjectSource> parseSource(const JsonValue& object, const PathNames& names,
                                  const Notice& notice) {
  CUTIS_TRY(kind, object.text("kind"));
  const auto row =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const auto& r) { return r.first == kind; });
  if (row == kKinds.end())
    return object.error("kind", "\"sample\", \"image\", \"capture\" or \"maps\"");
  ProjectSource source;
  source.kind = row->second;
  object.sayUnknown(
      {"kind", "path", "files", "rig", "lights", "mask", "layer", "colorspace", "exposure"},
      notice);
  if (source.kind == SourceKind::sample) return source;
  CUTIS_TRY(path, object.text("path"));
  if (path.empty()) return object.error("path", "the path of what was opened");
  source.path = names.pathOf(path);
  CUTIS_CHECK(parseFiles(object, names, notice, source));
  if (source.kind != SourceKind::maps) CUTIS_CHECK(parseOptions(object, names, source));
  return source;
}

Status parseNoise(const JsonValue& object, FitChoice& fit) {
  if (!object.has("noise")) return {};
  CUTIS_TRY(list, object.list("noise"));
  CUTIS_TRY(noise, list.asNumbers(2));
  if (!(noise[0] >= 0.0 && noise[1] >= 0.0)) {
    return object.error("noise", "two standard deviations of at least 0");
  }
  fit.noise = {noise[0], noise[1]};
  return {};
}

Status parseFixed(const JsonValue& object, const Notice& notice, FitChoice& fit) {
  if (!object.has("fixed")) return {};
  CUTIS_TRY(fixed, object.object("fixed"));
  std::array<std::string_view, kParameterCount> known;
  for (const Parameter k : kParameters) {
    const std::string name(parameterName(k));
    known[static_cast<std::size_t>(k)] = parameterName(k);
    if (!fixed.has(name)) continue;
    CUTIS_TRY(value, fixed.number(name));
    fit.fixed[static_cast<std::size_t>(k)] = value;
  }
  fixed.sayUnknown(known, notice);
  return {};
}

Status parseFree(const JsonValue& object, FitChoice& fit) {
  if (!object.has("free")) return {};
  CUTIS_TRY(names, object.array("free"));
  for (const JsonValue& element : names) {
    CUTIS_TRY(name, element.asText());
    if (name != kOxygenationName && name != kThicknessName) {
      return element.error("\"oxygenation\" or \"thickness\"");
    }
    (name == kOxygenationName ? fit.free.oxygenation : fit.free.thickness) = true;
  }
  return {};
}

Status parseSpecular(const JsonValue& object, FitChoice& fit) {
  if (!object.has("specular")) return {};
  CUTIS_TRY(word, object.text("specular"));
  for (const auto& [name, part] : kSpecularParts) {
    if (word == name) fit.specular = part;
  }
  if (!fit.specular)
    return object.error("specular", "\"included\", \"excluded\" or \"cross-polarised\"");
  if (!object.has("specular_share")) return {};
  CUTIS_TRY(share, object.number("specular_share"));
  if (!(share >= 0.0 && share <= kMostSpecularShare))
    return object.error("specular_share", "a number from 0 to 0.5");
  fit.specularShare = share;
  return {};
}

Result<FitChoice> parseFit(const JsonValue& object, const PathNames& names, const Notice& notice) {
  CUTIS_TRY(profile, object.text("profile"));
  CUTIS_TRY(method, object.text("method"));
  CUTIS_TRY(shading, object.boolean("shading", false));
  CUTIS_TRY(named, fitMethodNamed(method, object.file() + ": fit.method"));
  CUTIS_TRY(prior, object.text("prior", std::string()));
  object.sayUnknown({"profile", "method", "shading", "noise", "prior", "fixed", "free",
                     "discrepancy", "specular", "specular_share"},
                    notice);
  FitChoice fit = {names.pathOf(profile, profileNames()), named, shading};
  fit.prior = names.pathOf(prior).string();
  CUTIS_CHECK(parseNoise(object, fit));
  CUTIS_CHECK(parseFixed(object, notice, fit));
  CUTIS_CHECK(parseFree(object, fit));
  CUTIS_CHECK(parseSpecular(object, fit));
  if (object.has("discrepancy")) {
    CUTIS_TRY(discrepancy, object.boolean("discrepancy", false));
    fit.discrepancy = discrepancy;
  }
  return fit;
}

Result<ProjectView> parseView(const JsonValue& object, const PathNames& names,
                              const Notice& notice) {
  CUTIS_TRY(view, object.text("view"));
  CUTIS_TRY(light, object.text("light"));
  CUTIS_TRY(observer, object.text("observer"));
  CUTIS_TRY(adaptation, object.text("adaptation", std::string()));
  object.sayUnknown({"view", "place", "light", "observer", "adaptation"}, notice);
  ProjectView parsed;
  parsed.view = view;
  parsed.light = names.pathOf(light, spectralNames());
  parsed.observer = names.pathOf(observer, spectralNames());
  parsed.adaptation = adaptation;
  if (!object.has("place") || object.isNull("place")) return parsed;
  CUTIS_TRY(list, object.list("place"));
  CUTIS_TRY(place, list.asNumbers(3));
  if (!(place[2] > 0.0)) return object.error("place", "x, y and a zoom above 0");
  parsed.place = ViewPlace{place[0], place[1], place[2]};
  return parsed;
}

}  // namespace

bool isProjectFile(const fs::path& path) {
  return lowerExtension(path) == kProjectExtension;
}

std::string projectText(const Project& project, const fs::path& folder) {
  const PathNames names(folder);
  Json root;
  root[kVersion] = kNewestProject;
  root["source"] = sourceJson(project.source, project.fit.exposure, names);
  root["fit"] = fitJson(project.fit, names);
  root["maps"] = project.maps.empty() ? Json(nullptr) : Json(names.nameOf(project.maps));
  if (!project.editsOf.empty()) root["edits_of"] = names.nameOf(project.editsOf);
  addEditsTo(root, project.edits);
  root["view"] = viewJson(project.view, names);
  addPinsTo(root, project.pins);
  // A file's name may be no UTF-8.
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Project> parseProject(std::string_view text, const fs::path& path, const Notice& notice) {
  const PathNames names(fs::absolute(path).lexically_normal().parent_path());
  CUTIS_TRY(root, parseJson(text, path.string()));
  CUTIS_CHECK(checkVersion(root, kVersion, kNewestProject));
  root.sayUnknown({kVersion, "source", "fit", "maps", "edits_of", "edits", "regions", "view", kPins,
                   kPinSize, kPinReference},
                  notice);
  CUTIS_TRY(sourceObject, root.object("source"));
  CUTIS_TRY(fitObject, root.object("fit"));
  CUTIS_TRY(viewObject, root.object("view"));
  CUTIS_TRY(source, parseSource(sourceObject, names, notice));
  CUTIS_TRY(fit, parseFit(fitObject, names, notice));
  CUTIS_CHECK(parseExposure(sourceObject, fit));
  CUTIS_TRY(edits, parseEdits(root, notice));
  CUTIS_TRY(view, parseView(viewObject, names, notice));
  Project project = {source, fit, edits, view, {}};
  CUTIS_TRY(pins, parsePins(root, notice));
  project.pins = pins;
  if (root.has("edits_of")) {
    CUTIS_TRY(editsOf, root.text("edits_of"));
    project.editsOf = names.pathOf(editsOf);
  }
  if (root.has("maps") && !root.isNull("maps")) {
    CUTIS_TRY(maps, root.text("maps"));
    project.maps = names.pathOf(maps);
  }
  return project;
}

Result<Project> readProject(const fs::path& path, const Notice& notice) {
  CUTIS_TRY(text, readTextFile(path));
  return parseProject(text, path, notice);
}

}  // namespace cutis
