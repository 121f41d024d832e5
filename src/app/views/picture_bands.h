#pragma once  // internal to src/app/views

// Pictures computed band by band, on all cores.

#include <functional>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/render/skin_samples.h"

namespace cutis {

// Bands of one width, one below the other, as band(i) gives them for i in [0, count). Errors and
// cancellation: those of parallelFor.
Result<PictureBuffer> joinedBands(std::size_t count, const JobContext& context,
                                  const std::function<Result<PictureBuffer>(std::size_t i)>& band);

}  // namespace cutis
