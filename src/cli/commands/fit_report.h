#pragma once

// What a fit did, as JSON for scripts and benchmarks.

#include <filesystem>

#include "core/base/result.h"
#include "src/cli/commands/fit_source.h"

namespace cutis {

Status writeFitReport(const std::filesystem::path& path, const FittedSource& fitted,
                      const std::string& methodName);

}  // namespace cutis
