#pragma once

// What of a source depends on the profile: an albedo texture is read at the exposure that brings
// most of it into the profile's range of skin colours, and photographs by a camera get their
// colours under daylight from skin of the profile.

#include <filesystem>
#include <memory>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/app/engine.h"
#include "src/app/open/source.h"

namespace cutis {

// openSource(), an albedo texture at that exposure; a notice says so where it is not 1.
Result<Source> openForProfile(const std::filesystem::path& path,
                              const std::shared_ptr<const SkinModel>& model, Engine& engine,
                              const std::shared_ptr<TileStore>& store, const JobContext& context);

// What was opened for one profile, for another; as if it had been opened for that. Photographs are
// not read again. `path`: of an albedo texture; fails if the file is not the one that was opened
// any more.
Result<Source> changeProfile(const Source& source, const std::filesystem::path& path,
                             const std::shared_ptr<const SkinModel>& model, Engine& engine,
                             const std::shared_ptr<TileStore>& store, const JobContext& context);

}  // namespace cutis
