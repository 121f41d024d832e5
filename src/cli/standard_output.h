#pragma once

// What a command has found out, as text on the standard output.

#include <string_view>

#include "core/base/result.h"

namespace cutis {

// What is lost where a command prints tables, or a description that could not go to a file.
inline constexpr char kTablesLost[] = "the tables could not be written";
inline constexpr char kOutputLost[] = "it cannot be written to";

// The whole text, at once. `objection` says what to make of a failure (a full disk, a closed pipe).
// Take the line of progress off the terminal before (Session::clearProgress).
Status printText(std::string_view text, const char* objection);

}  // namespace cutis
