#include "core/skin/profile/parameter.h"

#include <cstddef>

#include "core/skin/profile/chromophore_table.h"

namespace cutis {

std::string_view parameterName(Parameter parameter) {
  return chromophoreTable()[static_cast<std::size_t>(parameter)].name;
}

std::string_view parameterSymbol(Parameter parameter) {
  return chromophoreTable()[static_cast<std::size_t>(parameter)].symbol;
}

std::string_view parameterUnit(Parameter parameter) {
  return chromophoreTable()[static_cast<std::size_t>(parameter)].unit;
}

std::optional<Parameter> parameterByName(std::string_view name) {
  for (const Parameter parameter : kParameters) {
    if (parameterName(parameter) == name) return parameter;
  }
  return std::nullopt;
}

}  // namespace cutis
