#pragma once  // internal to src/cli/commands/bench

#include <filesystem>

#include "core/base/result.h"
#include "src/bench/figures.h"

namespace cutis {

// All figures as JSON, for scripts. Errors: the file cannot be written.
Status writeBenchReport(const std::filesystem::path& path, const BenchFigures& figures);

}  // namespace cutis
