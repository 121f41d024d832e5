#pragma once  // internal to src/cli/commands

// Projects as the commands read them.

#include <string>

#include "core/base/result.h"
#include "src/app/export/export.h"
#include "src/cli/command.h"

namespace cutis {

// The source of a project with its edits, fitted now where the project holds no maps that still
// hold. What there is to say about it is noted.
Result<EditedAlbedo> openProjectAlbedo(const std::string& path, const Session& session,
                                       const JobContext& context);

}  // namespace cutis
