#pragma once  // internal to src/files/io

// Where a file really is that is to be written.

#include <filesystem>

#include "core/base/result.h"

namespace cutis {

// The path behind all symbolic links, so that what is replaced is the file and never a link to it;
// nothing need be there. Refuses with a sentence that names `path`: folders, devices, pipes,
// sockets, links that go round in circles or into a folder that is not there, streams of a process
// that are open already (/dev/stdout), files that may not be written to, and folders that may not.
Result<std::filesystem::path> outputTarget(const std::filesystem::path& path);

}  // namespace cutis
