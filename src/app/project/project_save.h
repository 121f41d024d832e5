#pragma once

// Saving a project: the fitted maps first, into a file that their content names, then the manifest.
// To rename the manifest is what saves: before that nothing of the project that was there is
// touched, and a program that is killed leaves it whole.

#include <filesystem>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/app/project/project.h"
#include "src/images/maps/maps_file.h"

namespace cutis {

// "NAME.cutis.data", which is there as long as it holds something.
std::filesystem::path dataFolder(const std::filesystem::path& project);

// Writes the project to `path`, replacing what is there. maps: the fitted maps; null where
// project.maps already names their file, of this project or of another that is copied from, or
// where nothing is fitted. Returns the project as it was saved. Of earlier files of maps only that
// is removed which the replaced manifest named in its own folder.
Result<Project> saveProject(const std::filesystem::path& path, Project project,
                            const MapsFile* maps, const JobContext& context);

// Removes what a save that was cut off by a kill left beside the project.
void removeLeftovers(const std::filesystem::path& project);

}  // namespace cutis
