#pragma once

// Which files a file stands for: itself, and what it names.

#include <filesystem>
#include <string>
#include <vector>

namespace cutis {

// Every file a path stands for: the path itself, and what a capture, rig, profile, recipe or
// project names and what that names in turn. A name of a built-in stands for itself. Files that
// cannot be read, and what they name, are left to their readers.
std::vector<std::string> inputFiles(const std::string& path);

// Whether two names are one file, which need not be there.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace cutis
