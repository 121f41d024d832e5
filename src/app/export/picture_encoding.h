#pragma once  // internal to src/app/export

// Pictures on their way into a file: from linear values to what the file is to hold.

#include <memory>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"
#include "src/color/color_space.h"

namespace cutis {

// Linear Rec.709 to the space, three planes, or one that is taken as grey; new planes.
Result<std::vector<Plane>> encodePicture(const std::vector<Plane>& linear, const ColorSpace& space,
                                         const std::shared_ptr<TileStore>& store,
                                         const JobContext& context);

}  // namespace cutis
