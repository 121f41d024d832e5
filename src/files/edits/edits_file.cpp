#include "src/files/edits/edits_file.h"

#include <cassert>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/echoed_text.h"
#include "core/skin/profile/parameter_names.h"
#include "src/files/io/text_file.h"

namespace cutis {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kVersion[] = "cutis_edits";

Result<double> parseFactor(const JsonValue& object) {
  CUTIS_TRY(factor, object.number("value"));
  if (factor >= 0.0 && factor <= kMostScale) return factor;
  return object.error("value", "from 0 to 1000");
}

Result<ParameterEdit> parseParameter(const JsonValue& object, const Notice& notice) {
  CUTIS_TRY(mode, object.text("mode"));
  ParameterEdit edit;
  if (mode == "scale") {
    CUTIS_TRY(factor, parseFactor(object));
    CUTIS_TRY(addition, object.number("add", 0.0));
    edit.scale = factor;
    edit.add = addition;
    object.sayUnknown({"mode", "value", "add"}, notice);
    return edit;
  }
  if (mode != "add" && mode != "set") {
    return object.error("mode", "\"scale\", \"add\" or \"set\" in this version, not " +
                                    inQuotes(mode) + "; leave the edit out or use a newer version");
  }
  CUTIS_TRY(value, object.number("value"));
  if (mode == "add") edit.add = value;
  if (mode == "set") edit.set = value;
  object.sayUnknown({"mode", "value"}, notice);
  return edit;
}

Status checkRegion(const JsonValue& object) {
  if (!object.has("region") || object.isNull("region")) return {};
  return object.error("region",
                      "null in this version, which has no regions; leave the edit out or use a "
                      "newer version");
}

Result<Edit> parseEdit(const JsonValue& object, const Notice& notice) {
  if (!object.isObject()) return object.error("an object");
  CUTIS_CHECK(checkRegion(object));
  Edit edit;
  CUTIS_TRY(name, object.text("name", std::string()));
  CUTIS_TRY(opacity, object.number("opacity", 1.0));
  if (opacity < 0.0 || opacity > 1.0) return object.error("opacity", "from 0 to 1");
  CUTIS_TRY(isOn, object.boolean("on", true));
  edit.name = name;
  edit.opacity = opacity;
  edit.enabled = isOn;
  std::vector<std::string_view> known = {"name", "region", "opacity", "on"};
  for (const Parameter k : kParameters) {
    known.push_back(parameterName(k));
    const std::string field(parameterName(k));
    if (!object.has(field)) continue;
    CUTIS_TRY(part, object.object(field));
    CUTIS_TRY(parameter, parseParameter(part, notice));
    edit.parameters[k] = parameter;
  }
  object.sayUnknown(known, notice);
  return edit;
}

Json jsonOf(const ParameterEdit& edit) {
  if (edit.set) return {{"mode", "set"}, {"value", *edit.set}};
  if (edit.scale == 1.0) return {{"mode", "add"}, {"value", edit.add}};
  Json scaled = {{"mode", "scale"}, {"value", edit.scale}};
  if (edit.add != 0.0) scaled["add"] = edit.add;
  return scaled;
}

Json jsonOf(const Edit& edit) {
  assert(edit.mask.empty());
  Json object;
  object["name"] = edit.name;
  object["region"] = nullptr;
  object["opacity"] = edit.opacity;
  object["on"] = edit.enabled;
  for (const Parameter k : kParameters) {
    const ParameterEdit& parameter = edit.parameters[k];
    if (!parameter.isNeutral()) object[std::string(parameterName(k))] = jsonOf(parameter);
  }
  return object;
}

}  // namespace

Result<EditStack> readEdits(std::string_view text, const std::string& place, const Notice& notice) {
  CUTIS_TRY(root, parseJson(text, place));
  CUTIS_CHECK(checkVersion(root, kVersion, kNewestEdits));
  root.sayUnknown({kVersion, "edits", "regions"}, notice);
  return parseEdits(root, notice);
}

Result<EditStack> readEditsFile(const std::filesystem::path& path, const Notice& notice) {
  CUTIS_TRY(text, readTextFile(path));
  return readEdits(text, path.string(), notice);
}

std::string editsText(const EditStack& edits) {
  Json root;
  root[kVersion] = kNewestEdits;
  addEditsTo(root, edits);
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<EditStack> parseEdits(const JsonValue& document, const Notice& notice) {
  CUTIS_TRY(list, document.array("edits"));
  EditStack edits;
  for (const JsonValue& element : list) {
    CUTIS_TRY(edit, parseEdit(element, notice));
    edits.push_back(edit);
  }
  if (!document.has("regions")) return edits;
  CUTIS_TRY(regions, document.array("regions"));
  if (regions.empty()) return edits;
  return document.error("regions",
                        "empty in this version, which has no regions; take them out or use a newer "
                        "version");
}

void addEditsTo(nlohmann::ordered_json& document, const EditStack& edits) {
  document["edits"] = Json::array();
  for (const Edit& edit : edits)
    document["edits"].push_back(jsonOf(edit));
  document["regions"] = Json::array();
}

}  // namespace cutis
