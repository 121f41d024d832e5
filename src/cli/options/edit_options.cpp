#include "src/cli/options/edit_options.h"

#include <array>
#include <utility>

#include "core/base/echoed_text.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/option_values.h"
#include "src/files/edits/edits_file.h"

namespace cutis {
namespace {

Status parseScale(const char* option, const std::string& text, ParameterEdit& edit) {
  if (text.empty()) return {};
  CUTIS_TRY(scale, realNumber(option, text, 0.0, kMostScale));
  edit.scale = scale;
  return {};
}

static_assert(kParameterCount == 5,
              "a sixth has a field in EditOptions, and its option here and in addEditOptions()");

Status parseScales(const EditOptions& options, Edit& edit) {
  auto& parameters = edit.parameters;
  CUTIS_CHECK(parseScale("--melanin", options.melanin, parameters[kMelanin]));
  CUTIS_CHECK(parseScale("--melanin-blend", options.melaninBlend, parameters[kMelaninBlend]));
  CUTIS_CHECK(parseScale("--carotene", options.carotene, parameters[kCarotene]));
  for (const Parameter blood : {kHaemoglobinDermal, kHaemoglobinEpidermal}) {
    CUTIS_CHECK(parseScale("--haemoglobin", options.haemoglobin, parameters[blood]));
  }
  CUTIS_CHECK(parseScale("--haemoglobin-dermal", options.haemoglobinDermal,
                         parameters[kHaemoglobinDermal]));
  return parseScale("--haemoglobin-epidermal", options.haemoglobinEpidermal,
                    parameters[kHaemoglobinEpidermal]);
}

Status parseAdditions(const EditOptions& options, Edit& edit) {
  std::array<bool, kParameterCount> given = {};
  for (const std::string& text : options.add) {
    CUTIS_TRY(addition, assignment("--add", text));
    if (std::exchange(given[addition.parameter], true)) {
      return usageError("--add", std::string(parameterName(addition.parameter)) +
                                     " is given twice; give it once");
    }
    edit.parameters[addition.parameter].add = addition.value;
  }
  return {};
}

Status parseSettings(const EditOptions& options, Edit& edit) {
  for (const std::string& text : options.set) {
    CUTIS_TRY(setting, assignment("--set", text));
    ParameterEdit& parameter = edit.parameters[setting.parameter];
    const std::string name(parameterName(setting.parameter));
    if (parameter.set) return usageError("--set", name + " is given twice; give it once");
    if (!parameter.isNeutral()) {
      return usageError("--set", name + " is also scaled or added to; choose one");
    }
    parameter.set = setting.value;
  }
  return {};
}

Result<Edit> parseEdit(const EditOptions& options) {
  if (!options.haemoglobin.empty() &&
      !(options.haemoglobinDermal.empty() && options.haemoglobinEpidermal.empty())) {
    return usageError("--haemoglobin",
                      "this sets both layers; give either this or the single layers");
  }
  Edit edit;
  CUTIS_CHECK(parseScales(options, edit));
  CUTIS_CHECK(parseAdditions(options, edit));
  CUTIS_CHECK(parseSettings(options, edit));
  return edit;
}

}  // namespace

void addEditOptions(CLI::App& command, EditOptions& options) {
  const auto factor = [&](const char* name, std::string& value, const char* text) {
    addOption(command, name, value, "S", text)->group("Edit");
  };
  factor("--melanin", options.melanin, "Multiply the melanin by S (1 changes nothing)");
  factor("--melanin-blend", options.melaninBlend, "Multiply the share of eumelanin by S");
  factor("--carotene", options.carotene, "Multiply the carotene by S");
  factor("--haemoglobin-dermal", options.haemoglobinDermal,
         "Scale the blood of the dermis by S; where there is more of it, more is added");
  factor("--haemoglobin-epidermal", options.haemoglobinEpidermal,
         "Scale the blood of the epidermis by S; where there is more of it, more is added");
  factor("--haemoglobin", options.haemoglobin, "Scale the blood of both layers by S");
  const auto assigned = [&](const char* name, std::vector<std::string>& values, const char* text) {
    addOption(command, name, values, "NAME=V", text)->group("Edit")->allow_extra_args(false);
  };
  assigned("--add", options.add,
           "Add V to a parameter, in its unit: melanin, haemoglobin_dermal and "
           "haemoglobin_epidermal are volume fractions, melanin_blend is a share from 0 to 1, "
           "carotene is in g/L; may be repeated");
  assigned("--set", options.set, "Set a parameter to V, in its unit; may be repeated");
  addOption(command, "--preset", options.preset, "FILE",
            "Edits that were saved (JSON); those of the other options come after them")
      ->group("Edit");
  addOption(command, "--mask", options.mask, "FILE",
            "Image of the maps' size: 0 keeps the original, 1 edits, between blends; its alpha "
            "counts where there is a shape in it, else its luminance (default: edit everywhere)")
      ->group("Edit");
}

Result<EditStack> parseEditOptions(const EditOptions& options, const Notice& notice) {
  CUTIS_TRY(edit, parseEdit(options));
  if (options.preset.empty()) return EditStack{edit};
  CUTIS_TRY(edits, readEditsFile(options.preset, notice));
  edits.push_back(edit);
  return edits;
}

Status loadEditMask(const EditOptions& options, const MaskedPicture& picture,
                    const std::shared_ptr<TileStore>& store, const JobContext& context,
                    EditStack& edits) {
  if (options.mask.empty()) return {};
  CUTIS_TRY(mask, readMask(options.mask, picture, store, context));
  for (Edit& edit : edits)
    edit.mask = mask;
  return {};
}

}  // namespace cutis
