#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "src/cli/bench_figures.h"

namespace cutis {

// Run time against error, both logarithmic, as an SVG that reads on white and on dark ground: every
// method without and with noise, what the paper published, and the bound.
std::string benchPlot(const BenchFigures& figures);

// Errors: the file cannot be written.
Status writeBenchPlot(const std::filesystem::path& path, const BenchFigures& figures);

}  // namespace cutis
