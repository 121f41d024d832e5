#pragma once

// The names of all parameters, in their order: what files and options may name.

#include <array>
#include <string_view>

#include "core/skin/profile/parameter.h"

namespace cutis {

std::array<std::string_view, kParameterCount> parameterNames();

}  // namespace cutis
