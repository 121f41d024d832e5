#pragma once  // internal to src/color

// The colour spaces that need no configuration.

#include <optional>
#include <string>
#include <vector>

#include "src/color/color_space.h"

namespace cutis {

// Index of the space this name or alias means; nothing if it is none of ours.
std::optional<int> builtInSpace(const std::string& name);
std::vector<std::string> builtInSpaceNames();

const ColorSpace& builtInSpaceAt(int index);

}  // namespace cutis
