#pragma once

// The one way this program writes files: a save is whole or did not happen.

#include <filesystem>
#include <functional>
#include <string_view>

#include "core/base/result.h"

namespace cutis {

// Calls write(temporary) with a path in the same folder and with the same extension, then flushes
// that file to the disk and renames it to `path`. On failure or cancellation the temporary is
// removed and whatever was at `path` is as it was. Fails before calling write if the folder does
// not exist or cannot be written to.
Status writeAtomically(const std::filesystem::path& path,
                       const std::function<Status(const std::filesystem::path& temporary)>& write);

// The same for a text.
Status writeTextAtomically(const std::filesystem::path& path, std::string_view text);

// Whether writeAtomically could succeed, found out before the work that leads up to it is done.
Status checkWritable(const std::filesystem::path& path);

}  // namespace cutis
