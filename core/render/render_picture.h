#pragma once

// Maps, edited and seen under a light: whole pictures for files, parts of them for the screen.

#include <vector>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"
#include "core/edit/edit_stack.h"
#include "core/skin/chromophore_maps.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/response_model.h"

namespace cutis {

// One float per pixel and row of the response model, row by row of the picture; 0 where there is no
// estimate.
struct PictureBuffer {
  int width = 0;
  int height = 0;
  std::vector<std::vector<float>> channels;
  std::vector<bool> present;
};

// Every step-th pixel of every step-th row of rect. Cost: about 30 ns per pixel on one core.
Result<PictureBuffer> renderPart(const ChromophoreMaps& maps, const EditStack& edits,
                                 const ParameterAxes& axes, const ResponseModel& picture,
                                 const Rect& rect, int step);

// The whole picture, one plane per row of the response model.
Result<std::vector<Plane>> renderPicture(const ChromophoreMaps& maps, const EditStack& edits,
                                         const ParameterAxes& axes, const ResponseModel& picture,
                                         const std::shared_ptr<TileStore>& store,
                                         const JobContext& context);

// The maps with the edits applied; states and constants are as they were.
Result<ChromophoreMaps> editMaps(const ChromophoreMaps& maps, const EditStack& edits,
                                 const ParameterAxes& axes, const std::shared_ptr<TileStore>& store,
                                 const JobContext& context);

// Edited albedo: source × model edited ÷ model original, channel by channel in linear Rec.709, so
// that hair, pores and make-up survive; pixels without an estimate keep the source. With `pure` the
// edited model alone replaces the source where there is an estimate. Pixels that the edits leave
// alone keep the source to the last bit. albedo: the picture under D65. source: three channels,
// linear Rec.709, of the same part.
Result<PictureBuffer> editAlbedoPart(PictureBuffer source, const ChromophoreMaps& maps,
                                     const EditStack& edits, const ParameterAxes& axes,
                                     const ResponseModel& albedo, bool pure, const Rect& rect,
                                     int step);

// The same for the whole picture; source: three planes.
Result<std::vector<Plane>> editAlbedo(const std::vector<Plane>& source, const ChromophoreMaps& maps,
                                      const EditStack& edits, const ParameterAxes& axes,
                                      const ResponseModel& albedo, bool pure,
                                      const std::shared_ptr<TileStore>& store,
                                      const JobContext& context);

}  // namespace cutis
