#pragma once  // internal to src/cli/commands

// What a fit did, as JSON for scripts and benchmarks.

#include <filesystem>

#include "core/base/result.h"
#include "src/app/open/source_fit.h"

namespace cutis {

Status writeFitReport(const std::filesystem::path& path, const FittedSource& fitted);

}  // namespace cutis
