#include "core/skin/profile/parameter.h"

#include <cstddef>

namespace cutis {
namespace {

struct Naming {
  std::string_view name;
  std::string_view symbol;
};

constexpr std::array<Naming, kParameterCount> kNaming = {{{"melanin", "C_m"},
                                                          {"melanin_blend", "β_m"},
                                                          {"haemoglobin_dermal", "C_hd"},
                                                          {"haemoglobin_epidermal", "C_he"},
                                                          {"carotene", "C_bc"}}};

}  // namespace

std::string_view parameterName(Parameter parameter) {
  return kNaming[static_cast<std::size_t>(parameter)].name;
}

std::string_view parameterSymbol(Parameter parameter) {
  return kNaming[static_cast<std::size_t>(parameter)].symbol;
}

std::optional<Parameter> parameterByName(std::string_view name) {
  for (const Parameter parameter : kParameters) {
    if (parameterName(parameter) == name) return parameter;
  }
  return std::nullopt;
}

}  // namespace cutis
