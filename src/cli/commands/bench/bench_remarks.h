#pragma once  // internal to src/cli/commands/bench

// What the figures of a run say in words, for the table and for the plot.

#include <string>
#include <vector>

#include "src/bench/figures.h"

namespace cutis {

// What noise does to each method, and what the paper's error was measured on. Sentences.
std::vector<std::string> noiseRemarks(const BenchFigures& figures);

}  // namespace cutis
