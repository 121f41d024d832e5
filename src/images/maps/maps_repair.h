#pragma once  // internal to src/images/maps

// What no computation could go on with, taken out of maps that were read. For the files of this
// folder.

#include <cstddef>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"
#include "core/skin/chromophore_maps.h"

namespace cutis {

// Pixels with a value that is not finite, a state that is none, or an estimate with a constant that
// no profile can have, become invalid with values 0.
// Returns their number.
Result<std::size_t> invalidateSpoiledPixels(ChromophoreMaps& maps, const JobContext& context);

// Pixels outside `stored`, which a compositing program cropped away, become masked with values 0.
Status maskOutside(const Rect& stored, ChromophoreMaps& maps, const JobContext& context);

Status zeroWhereNotFinite(Plane& plane, const JobContext& context);

}  // namespace cutis
