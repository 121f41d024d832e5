#pragma once

// Text files of limited size, read whole.

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace cutis {

// The whole file, or all that comes through a pipe until it is closed; cancelled if the program is
// interrupted while nothing comes. Fails with a sentence if it is missing, a folder, unreadable,
// empty or larger than `limitBytes`.
Result<std::string> readTextFile(const std::filesystem::path& path,
                                 std::size_t limitBytes = std::size_t{64} << 20);

}  // namespace cutis
