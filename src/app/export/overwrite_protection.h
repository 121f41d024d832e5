#pragma once

// Files that are read are never written to.

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace cutis {

// Every file a path stands for: the path itself, and what a capture, rig, profile, recipe or
// project names and what that names in turn. A name of a built-in stands for itself. Files that
// cannot be read, and what they name, are left to their readers.
std::vector<std::string> inputFiles(const std::string& path);

// Whether two names are one file, which need not be there.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

// A usage error if the output is one of the inputs or of the files that they name, under whatever
// name or link. Empty names are passed over.
Status checkNotInput(const std::string& output, const std::vector<std::string>& inputs);

}  // namespace cutis
