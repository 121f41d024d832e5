#pragma once

// Tables of radiative transfer on disk, so that each is made once per profile. As with
// src/files/profiles/table_cache.h a file that does not fit is made again, with a notice, and a
// folder that cannot be written is no error.

#include <filesystem>
#include <memory>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/layers/table.h"

namespace cutis {

// The profile's table at all wavelengths, from `folder` (see cacheFolder(); empty: no cache) or
// newly made, which takes about 2 s on one core.
Result<std::shared_ptr<const LayerTable>> cachedLayerTable(const Profile& profile,
                                                           const std::filesystem::path& folder,
                                                           const JobContext& context);

}  // namespace cutis
