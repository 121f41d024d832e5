#pragma once

// Files that are read are never written to.

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace cutis {

// Every file a path stands for: a capture's manifest, photographs and mask, or the path itself.
// Fails if a capture.json cannot be read.
Result<std::vector<std::string>> inputFiles(const std::string& path);

// Whether two names are one file, which need not be there.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

// A usage error if the output is one of the inputs, under whatever name. Empty names are passed
// over.
Status checkNotInput(const std::string& output, const std::vector<std::string>& inputs);

}  // namespace cutis
