#pragma once  // internal to src/cli/commands/info

// What a file is and what is in it, in lines of "name: value".

#include <string>

#include "core/base/result.h"
#include "src/cli/command.h"

namespace cutis {

Result<std::string> describeFile(const std::string& path, const Session& session);

}  // namespace cutis
