#pragma once

// What stands at a path that somebody named as an input. Reads no content and never waits.

#include <filesystem>

#include "core/base/result.h"

namespace cutis {

// The status of what is there, a folder or a file of whatever kind. Fails with a sentence where
// nothing is, and with another where the permissions of a folder keep from finding out.
Result<std::filesystem::file_status> presentStatus(const std::filesystem::path& path);

}  // namespace cutis
