#pragma once  // internal to src/cli/commands/info

#include <string>

#include "core/base/result.h"
#include "src/cli/command.h"

namespace cutis {

// What a project holds, read from its manifest alone, and which of its files are missing.
Result<std::string> describeProject(const std::string& path, const Session& session);

}  // namespace cutis
