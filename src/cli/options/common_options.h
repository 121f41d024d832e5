#pragma once

// Options that every command has.

#include <string>

#include <CLI/App.hpp>

#include "core/base/result.h"

namespace cutis {

struct CommonOptions {
  std::string threads;  // as it was given; empty: all cores
  bool quiet = false;
};

void addCommonOptions(CLI::App& command, CommonOptions& options);

// 0 for all cores.
Result<int> threadCount(const CommonOptions& options);

}  // namespace cutis
