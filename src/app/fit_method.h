#pragma once

// The ways to fit, by the names of the command line.

#include <string>

#include "core/base/result.h"
#include "core/fit/fit_options.h"

namespace cutis {

// "refined", "three-stage", "full-search", "network".
std::string fitMethodName(FitMethod method);

// The way back. Fails with a sentence for any other name; `place` stands in front of it.
Result<FitMethod> fitMethodNamed(const std::string& name, const std::string& place);

}  // namespace cutis
