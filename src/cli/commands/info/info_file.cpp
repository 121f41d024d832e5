#include "src/cli/commands/info/info_file.h"

#include <array>
#include <filesystem>
#include <fstream>

#include "core/analyse/diffusion_domain.h"
#include "core/analyse/maps_summary.h"
#include "core/base/echoed_text.h"
#include "core/base/number_text.h"
#include "core/base/word_list.h"
#include "src/app/project/manifest.h"
#include "src/cli/commands/info/info_line.h"
#include "src/cli/commands/info/info_project.h"
#include "src/files/io/json_file.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/recipe_file.h"
#include "src/files/rig_file.h"
#include "src/images/capture/capture_file.h"
#include "src/images/image_file.h"
#include "src/images/maps/maps_file.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kTableMark = "CUTIS TABLE 1\n";

std::string sizeText(int width, int height) {
  return std::to_string(width) + " × " + std::to_string(height);
}

std::vector<std::string> lightsOf(const Rig& rig) {
  std::vector<std::string> names;
  for (const RigLight& light : rig.lights)
    names.push_back(light.name);
  return names;
}

constexpr std::array<const char*, kPixelStateCount> kStateNames = {"solved", "masked", "invalid",
                                                                   "saturated", "no convergence"};

std::string statesText(const StateCounts& counts) {
  std::string text;
  for (std::size_t s = 0; s < counts.size(); ++s) {
    if (counts[s] == 0) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(counts[s]) + " " + kStateNames[s];
  }
  return text;
}

Result<std::string> valuesText(const ChromophoreMaps& maps, const Plane& plane) {
  CUTIS_TRY(spread, spreadOf(plane, maps.state));
  if (!spread) return std::string();
  const auto number = [](float value) { return formatNumber(double{value}, 4); };
  return "median " + number(spread->median) + ", 5–95 % " + number(spread->low) + " to " +
         number(spread->high);
}

// How much of the maps lies outside diffusion's domain, for maps of a profile that uses it.
Result<std::string> diffusionText(const MapsFile& file, const std::string& path,
                                  const Session& session) {
  if (file.attributes.profileJson.empty()) return std::string();
  CUTIS_TRY(profile, parseProfile(file.attributes.profileJson, path));
  CUTIS_TRY(outside, shareOutsideDiffusion(file.maps, profile, session.context));
  if (!outside) return std::string();
  return percentText(*outside, 2) + " of the pixels absorb more visible light than they scatter";
}

Result<std::string> describeMaps(const std::string& path, const Session& session) {
  CUTIS_TRY(file, readMaps(path, PixelFormat::float32, session.store, session.context));
  const MapsAttributes& attributes = file.attributes;
  std::string text = line("kind", "chromophore maps");
  text += line("size", sizeText(file.maps.width(), file.maps.height()));
  text += line("profile", attributes.profileName +
                              (attributes.profileJson.empty() ? " (not carried by the file)" : ""));
  text += line("rig", attributes.rigName);
  text += line("method", attributes.method);
  text += line("exposure", formatNumber(attributes.exposure));
  if (attributes.specularShare > 0.0)
    text += line("surface taken off", formatNumber(attributes.specularShare, 4));
  text += line("source colour space", attributes.sourceColorSpace);
  for (const SourceReference& source : attributes.sources) {
    text += line("source", source.file + " (" + source.hash + ")");
  }
  std::vector<std::string> further;
  if (!file.deviations.empty()) further.emplace_back("deviation");
  if (!file.residuals.empty()) further.emplace_back("residual");
  if (!file.shading.empty()) further.emplace_back("shading");
  if (file.maps.free().count() > 0) further.emplace_back("constants");
  if (!file.maps.coefficients.empty()) further.emplace_back("discrepancy");
  if (!file.constantDeviations.empty()) further.emplace_back("constants_deviation");
  text += line("further parts", wordList(further, ", "));
  CUTIS_TRY(counts, countStates(file.maps.state));
  text += line("pixels", statesText(counts));
  CUTIS_TRY(diffusion, diffusionText(file, path, session));
  text += line("outside diffusion's domain", diffusion);
  for (const Parameter parameter : kParameters) {
    CUTIS_TRY(values, valuesText(file.maps, file.maps.values[parameter]));
    text += line(std::string(parameterName(parameter)), values);
  }
  for (const SkinConstant constant : kSkinConstants) {
    if (!file.maps.free().has(constant)) continue;
    CUTIS_TRY(values, valuesText(file.maps, file.maps.constants[constant]));
    text += line(std::string(constantName(constant)), values);
  }
  return text;
}

Result<std::string> describeCapture(const std::string& path, const Session& session) {
  CUTIS_TRY(capture, readCapture(path, {}, session.store, session.context));
  const Measurements& measurements = capture.measurements;
  std::string text = line("kind", "capture");
  text += line("size", sizeText(measurements.width(), measurements.height()));
  text += line("rig", measurements.rig.name);
  text += line("camera", measurements.rig.camera.name);
  text += line("encoding", capture.encoding);
  for (std::size_t k = 0; k < capture.sources.size(); ++k) {
    text += line("light " + measurements.rig.lights[k].name, capture.sources[k].file);
  }
  CUTIS_TRY(counts, countStates(measurements.state));
  std::string states = statesText(counts);
  if (states.find("solved") != std::string::npos) {
    states.replace(states.find("solved"), 6, "to solve");
  }
  return text + line("pixels", states);
}

std::string colorsText(const FileColors& colors, const std::string& path) {
  std::string text;
  const auto decided = decideColors(colors, {}, path);
  if (decided.failed()) {
    text += line("colours", decided.error().message);
  } else if (decided) {
    const ColorDecision& decision = decided.value();
    text += line("colour space",
                 colors.statements.empty() ? "not stated in the file" : colors.stated());
    text += line("colours", decision.sentence);
    for (const std::string& contradiction : decision.contradictions)
      text += line("contradiction", contradiction);
  }
  for (const ColorStatement& statement : colors.statements) {
    text += line("statement", statement.origin + ": " + statement.meaning());
  }
  return text;
}

std::string orientationText(const ImageHeader& header) {
  if (header.orientation == Orientation::upright) return {};
  return "lies turned in the file (orientation " +
         std::to_string(static_cast<int>(header.orientation)) + "), is read upright";
}

std::string alphaText(const ImageHeader& header) {
  if (header.layer.alpha < 0) return {};
  return header.alphaKind == AlphaKind::associated ? "colours are multiplied by it"
                                                   : "colours are straight";
}

// Which layer is read, where there are several.
std::string layerText(const ImageHeader& header, const std::string& chosen) {
  if (!chosen.empty()) return {};
  if (header.isLayerOpen()) return "none of plain channels; --layer chooses";
  if (!header.layer.colors || header.layer.name.empty()) return {};
  return header.otherLayers.empty()
             ? inQuotes(header.layer.name)
             : inQuotes(header.layer.name) + ", the first; --layer chooses another";
}

// What of the file stays unread.
std::string furtherText(const ImageHeader& header) {
  if (!header.hasFurtherParts || header.kind == ImageFileKind::openExr) return {};
  return header.kind == ImageFileKind::webP ? "an animation, of which the first frame is read"
                                            : "several, of which the first is read";
}

Result<std::string> describeImage(const std::string& path, const std::string& layer,
                                  const Session& session) {
  CUTIS_TRY(header, readImageHeader(path, session.context, layer));
  CUTIS_TRY(layers, listLayers(path, session.context));
  std::string text = line("kind", "image");
  text += line("size", sizeText(header.width, header.height));
  text += line("orientation", orientationText(header));
  text += line("channels",
               wordList(layer.empty() ? header.channelNames : header.layer.channelNames, ", "));
  text += line("layers", layers.size() > 1 ? layerNames(layers) : "");
  text += line("read layer", layerText(header, layer));
  text += line(header.kind == ImageFileKind::webP ? "frames" : "pages", furtherText(header));
  text += line("alpha", alphaText(header));
  text += line("samples", sampleTypeName(header.sourceType));
  text += colorsText(header.colors, path);
  for (const char* name : {"Make", "Model", "DateTime", "ImageDescription", "Copyright"}) {
    text += line(name, header.metadata.text(name).value_or(""));
  }
  return text;
}

std::string describeRig(const Rig& rig) {
  return line("kind", "rig") + line("name", rig.name) + line("camera", rig.camera.name) +
         line("lights", wordList(lightsOf(rig), ", ")) +
         line("noise", formatNumber(rig.noise.read) + " constant, " +
                           formatNumber(rig.noise.proportional) + " proportional");
}

std::string describeProfile(const Profile& profile) {
  std::string text = line("kind", "profile of skin") + line("name", profile.name) +
                     line("description", profile.description);
  for (const Parameter parameter : kParameters) {
    text += line(std::string(parameterName(parameter)),
                 "0 to " + formatNumber(profile.axes[parameter].maximum));
  }
  return text;
}

Result<std::string> describeJson(const std::string& path, const Session& session) {
  CUTIS_TRY(root, readJson(path));
  if (root.has("cutis_capture")) return describeCapture(path, session);
  // A name without a folder could be a built-in one.
  const std::string file = fs::absolute(path).string();
  if (root.has("cutis_rig")) {
    CUTIS_TRY(rig, loadRig(file, {}, path, session.context.notice));
    return describeRig(rig);
  }
  if (root.has("cutis_profile")) {
    CUTIS_TRY(profile, loadProfile(file, path));
    return describeProfile(profile);
  }
  if (root.has("cutis_recipe")) {
    CUTIS_TRY(recipe, loadRecipe(file, path));
    return line("kind", "recipe of a skin patch") +
           line("size", sizeText(recipe.width, recipe.height)) +
           line("seed", std::to_string(recipe.seed));
  }
  return inputError(path,
                    "this is not a capture, rig, profile or recipe; such a file begins with "
                    "\"cutis_capture\", \"cutis_rig\", \"cutis_profile\" or "
                    "\"cutis_recipe\"");
}

bool isTable(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;  // a pipe would keep us waiting
  std::string mark(kTableMark.size(), '\0');
  std::ifstream stream(path, std::ios::binary);
  return stream.read(mark.data(), static_cast<std::streamsize>(mark.size())) && mark == kTableMark;
}

}  // namespace

Result<std::string> describeFile(const std::string& path, const std::string& layer,
                                 const Session& session) {
  if (!layer.empty()) return describeImage(path, layer, session);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return describeCapture(path, session);
  if (isProjectFile(path)) return describeProject(path, session);
  if (looksLikeCapture(path)) return describeJson(path, session);
  if (isTable(path)) {
    return line("kind", "cached table of skin; it can be deleted and is then built again") +
           line("bytes", std::to_string(fs::file_size(path, ignored)));
  }
  if (isMapsFile(path)) return describeMaps(path, session);
  return describeImage(path, {}, session);
}

}  // namespace cutis
