#pragma once  // internal to src/cli/commands/bench

// The figures as tables for a terminal, one function for each part of a run, so that every table
// can be shown as soon as its figures are there. Each begins with an empty line but the first.

#include <string>

#include "src/bench/figures.h"

namespace cutis {

// The machine, and how to read what follows.
std::string benchHeader(const BenchFigures& figures);
// The bound, and what the paper published.
std::string boundTables(const BenchFigures& figures);
// Networks by themselves: what each half of them leaves, and what they cost.
std::string networkTable(const BenchFigures& figures);
// Errors of the methods; of their parameters; by skin tone.
std::string methodTables(const BenchFigures& figures);
std::string sampleTable(const BenchFigures& figures);
// Empty for a profile without a discrepancy.
std::string discrepancyTable(const BenchFigures& figures);
std::string coverageTables(const BenchFigures& figures);
// Empty for a rig whose lights cannot be compared.
std::string lightTable(const BenchFigures& figures);
std::string parameterTable(const BenchFigures& figures);
std::string startTable(const BenchFigures& figures);
std::string encodingTable(const BenchFigures& figures);
std::string sizeTable(const BenchFigures& figures);
std::string scalingTable(const BenchFigures& figures);
std::string goalTable(const BenchFigures& figures);

}  // namespace cutis
