#pragma once  // internal to src/cli/commands/info

// What a file is and what is in it, in lines of "name: value".

#include <string>

#include "core/base/result.h"
#include "src/cli/command.h"

namespace cutis {

// layer: of an image; empty: see readImageHeader().
Result<std::string> describeFile(const std::string& path, const std::string& layer,
                                 const Session& session);

}  // namespace cutis
