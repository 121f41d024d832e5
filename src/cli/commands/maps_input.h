#pragma once  // internal to src/cli/commands

// Maps as the commands read them: with the model they were made with.

#include <memory>
#include <string>

#include "core/base/result.h"
#include "src/cli/command.h"
#include "src/images/maps/maps_file.h"

namespace cutis {

struct OpenedMaps {
  MapsFile file;
  std::shared_ptr<const SkinModel> model;
};

// Maps carry their profile; `profile` (--profile) stands in only where they do not, and is refused
// where they do.
Result<OpenedMaps> openMaps(const std::string& path, const std::string& profile,
                            const Session& session, const JobContext& context);

void addMapsProfileOption(CLI::App& command, std::string& profile);

}  // namespace cutis
