#pragma once

// The edited albedo of a scene, written to a file.

#include <filesystem>
#include <memory>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/app/document/scene.h"
#include "src/app/engine.h"

namespace cutis {

// Sample type and colour space are those of the source where the file's format has them, else the
// format's usual ones: half and linear Rec.709, or integers and sRGB. Refuses to write over one of
// `sources`. Precondition: the scene has a source.
Status exportAlbedo(const Scene& scene, Engine& engine, const std::filesystem::path& path,
                    const std::vector<std::filesystem::path>& sources,
                    const std::shared_ptr<TileStore>& store, const JobContext& context);

}  // namespace cutis
