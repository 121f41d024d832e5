#include "core/skin/profile/parameter_names.h"

#include <cstddef>

namespace cutis {

std::array<std::string_view, kParameterCount> parameterNames() {
  std::array<std::string_view, kParameterCount> names;
  for (const Parameter parameter : kParameters)
    names[static_cast<std::size_t>(parameter)] = parameterName(parameter);
  return names;
}

}  // namespace cutis
