#pragma once

// --free: constants of the profile that a measurement decides instead.

#include <string>

#include "core/base/result.h"
#include "core/skin/profile/free_constants.h"

namespace cutis {

// "oxygenation", "thickness" or both with a comma; empty: none.
Result<FreeConstants> freeConstants(const std::string& option, const std::string& text);

}  // namespace cutis
