#include "src/cli/options/edit_options.h"

#include <array>
#include <utility>

#include "src/cli/options/option_values.h"
#include "src/images/capture/mask_file.h"

namespace cutis {
namespace {

constexpr double kMostScale = 1000.0;

Status parseScale(const char* option, const std::string& text, ParameterEdit& edit) {
  if (text.empty()) return {};
  CUTIS_TRY(scale, realNumber(option, text, 0.0, kMostScale));
  edit.scale = scale;
  return {};
}

static_assert(kParameterCount == 5,
              "a sixth has a field in EditArguments, and its option here and in addEditOptions()");

Status parseScales(const EditArguments& arguments, Edit& edit) {
  auto& parameters = edit.parameters;
  CUTIS_CHECK(parseScale("--melanin", arguments.melanin, parameters[kMelanin]));
  CUTIS_CHECK(parseScale("--melanin-blend", arguments.melaninBlend, parameters[kMelaninBlend]));
  CUTIS_CHECK(parseScale("--carotene", arguments.carotene, parameters[kCarotene]));
  for (const Parameter blood : {kHaemoglobinDermal, kHaemoglobinEpidermal}) {
    CUTIS_CHECK(parseScale("--haemoglobin", arguments.haemoglobin, parameters[blood]));
  }
  CUTIS_CHECK(parseScale("--haemoglobin-dermal", arguments.haemoglobinDermal,
                         parameters[kHaemoglobinDermal]));
  return parseScale("--haemoglobin-epidermal", arguments.haemoglobinEpidermal,
                    parameters[kHaemoglobinEpidermal]);
}

Status parseAdditions(const EditArguments& arguments, Edit& edit) {
  std::array<bool, kParameterCount> given = {};
  for (const std::string& text : arguments.add) {
    CUTIS_TRY(addition, assignment("--add", text));
    if (std::exchange(given[addition.parameter], true)) {
      return usageError("--add", std::string(parameterName(addition.parameter)) +
                                     " is given twice; give it once");
    }
    edit.parameters[addition.parameter].add = addition.value;
  }
  return {};
}

Status parseSettings(const EditArguments& arguments, Edit& edit) {
  for (const std::string& text : arguments.set) {
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

}  // namespace

void addEditOptions(CLI::App& command, EditArguments& arguments) {
  const auto factor = [&](const char* name, std::string& value, const char* text) {
    command.add_option(name, value, text)->type_name("S")->group("Edit");
  };
  factor("--melanin", arguments.melanin, "Multiply the melanin by S (1 changes nothing)");
  factor("--melanin-blend", arguments.melaninBlend, "Multiply the share of eumelanin by S");
  factor("--carotene", arguments.carotene, "Multiply the carotene by S");
  factor("--haemoglobin-dermal", arguments.haemoglobinDermal,
         "Scale the blood of the dermis by S, the more of it the more");
  factor("--haemoglobin-epidermal", arguments.haemoglobinEpidermal,
         "Scale the blood of the epidermis by S, the more of it the more");
  CLI::Option* both = command.add_option("--haemoglobin", arguments.haemoglobin,
                                         "Scale the blood of both layers by S");
  both->type_name("S")->group("Edit");
  const auto assigned = [&](const char* name, std::vector<std::string>& values, const char* text) {
    command.add_option(name, values, text)
        ->type_name("NAME=V")
        ->group("Edit")
        ->allow_extra_args(false);
  };
  assigned("--add", arguments.add,
           "Add V to a parameter, in its unit: melanin, haemoglobin_dermal and "
           "haemoglobin_epidermal are volume fractions, melanin_blend is a share from 0 to 1, "
           "carotene is in g/L; may be repeated");
  assigned("--set", arguments.set, "Set a parameter to V, in its unit; may be repeated");
  command
      .add_option("--mask", arguments.mask,
                  "Image of the maps' size: 0 keeps the original, 1 edits, between blends "
                  "(default: edit everywhere)")
      ->type_name("FILE")
      ->group("Edit");
}

Result<Edit> parseEdit(const EditArguments& arguments) {
  if (!arguments.haemoglobin.empty() &&
      !(arguments.haemoglobinDermal.empty() && arguments.haemoglobinEpidermal.empty())) {
    return usageError("--haemoglobin", "this sets both layers; give either it or the layers");
  }
  Edit edit;
  CUTIS_CHECK(parseScales(arguments, edit));
  CUTIS_CHECK(parseAdditions(arguments, edit));
  CUTIS_CHECK(parseSettings(arguments, edit));
  return edit;
}

Status loadEditMask(const EditArguments& arguments, int width, int height,
                    const std::string& subject, const std::shared_ptr<TileStore>& store,
                    const JobContext& context, Edit& edit) {
  if (arguments.mask.empty()) return {};
  CUTIS_TRY(mask, readMask(arguments.mask, width, height, "'" + subject + "'", store, context));
  edit.mask = mask;
  return {};
}

}  // namespace cutis
