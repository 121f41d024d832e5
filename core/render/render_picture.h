#pragma once

// Edited skin seen under a light: whole pictures for files, parts of them for the screen.
//
// Thread-safe: pure functions. Maps are finite (src/images/maps/maps_file.h sees to that).

#include <memory>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"
#include "core/render/edited_skin.h"
#include "core/render/skin_samples.h"
#include "core/skin/response_model.h"

namespace cutis {

// Every step-th pixel of every step-th row of rect. Cost: about 30 ns per pixel on one core.
// Precondition, here and below: the response has the free constants of the skin.
Result<PictureBuffer> renderPart(const EditedSkin& skin, const ResponseModel& response,
                                 const Rect& rect, int step);

// The whole picture, one plane per row of the response model.
Result<std::vector<Plane>> renderPicture(const EditedSkin& skin, const ResponseModel& response,
                                         const std::shared_ptr<TileStore>& store,
                                         const JobContext& context);

// The maps with the edits applied; states and constants are as they were.
Result<ChromophoreMaps> editMaps(const EditedSkin& skin, const std::shared_ptr<TileStore>& store,
                                 const JobContext& context);

// Edited albedo: source × model edited ÷ model original, channel by channel in linear Rec.709, so
// that hair, pores and make-up survive; pixels without an estimate keep the source. With `pure` the
// edited model alone replaces the source where there is an estimate. Pixels that the edits leave
// alone keep the source to the last bit. albedo: the response under D65. source: three channels,
// linear Rec.709, of the same part.
Result<PictureBuffer> editAlbedoPart(PictureBuffer source, const EditedSkin& skin,
                                     const ResponseModel& albedo, bool pure, const Rect& rect,
                                     int step);

}  // namespace cutis
