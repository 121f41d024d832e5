#pragma once

// The one way this program writes files: a save is whole or did not happen.

#include <filesystem>
#include <functional>
#include <string_view>

#include "core/base/result.h"

namespace cutis {

// Calls write(temporary) with a path in the same folder and with the same extension, then flushes
// that file to the disk and renames it to `path`. On failure or cancellation the temporary is
// removed and whatever was at `path` is as it was.
//
// A file that is replaced keeps its mode and, where the system lets us, its owner, group, access
// list and extended attributes; its other hard links keep the old content. A symbolic link stays,
// and what it leads to is replaced. A new file has the mode that the user's umask gives it.
//
// Fails before calling write where nothing could be put: the folder is not there or may not be
// written to, the file is protected, a folder, a device, a pipe or an open stream (/dev/stdout).
// A file is never replaced by an empty one.
Status writeAtomically(const std::filesystem::path& path,
                       const std::function<Status(const std::filesystem::path& temporary)>& write);

// The same for a text.
Status writeTextAtomically(const std::filesystem::path& path, std::string_view text);

// Whether writeAtomically could succeed, found out before the work that leads up to it is done.
Status checkWritable(const std::filesystem::path& path);

}  // namespace cutis
