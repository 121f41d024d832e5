#pragma once

// The words of a command line, looked at before they are parsed: unknown commands and options with
// what may have been meant, and names that belong to a later version.

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "core/base/result.h"

namespace cutis {

// `words`: without the program's name.
Status checkCommandLine(const CLI::App& app, const std::vector<std::string>& words);

// What the parser threw, as one of our errors.
Error usageErrorOf(const CLI::App& app, const CLI::ParseError& error);

inline constexpr char kNotInThisVersion[] = "not in this version";

}  // namespace cutis
