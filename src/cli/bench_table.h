#pragma once

#include <string>

#include "src/cli/bench_figures.h"

namespace cutis {

// The figures as tables for a terminal.
std::string benchTables(const BenchFigures& figures);

}  // namespace cutis
