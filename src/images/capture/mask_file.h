#pragma once

// Masks: pictures of which pixels count. 0 leaves a pixel out, 1 includes it; between the two an
// edit blends and a fit solves.

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"

namespace cutis {

// The first channel of an image of any kind, clamped to [0, 1]; NaN counts as 0. The size must be
// that of the picture it is for, which `subject` names in the error ("white.exr").
Result<Plane> readMask(const std::filesystem::path& path, int width, int height,
                       const std::string& subject, const std::shared_ptr<TileStore>& store,
                       const JobContext& context);

}  // namespace cutis
