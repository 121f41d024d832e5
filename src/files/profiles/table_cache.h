#pragma once

// Tables of skin on disk, so that each is built once per profile and rig.
//
// A cached file names the content it was made from, carries a checksum and is verified on load; one
// that is damaged, of another version or of other content is built again, with a notice. A cache
// that cannot be written is no error: the next run builds the table again.

#include <filesystem>
#include <memory>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/table/skin_table.h"

namespace cutis {

// The table for these rows, from `folder` (see cacheFolder(); empty: no cache) or newly built.
Result<std::shared_ptr<const SkinTable>> cachedSkinTable(const SkinModel& model,
                                                         const SpectrumRows& rows,
                                                         const std::filesystem::path& folder,
                                                         const JobContext& context);

}  // namespace cutis
