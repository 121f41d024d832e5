#pragma once

// How different two pictures of the same place look, or by how much two maps differ.
//
// Colours: CIEDE2000 (CIE 142-2001; Sharma, Wu and Dalal 2005) of linear Rec.709 under the white of
// the two, D65. In float, within 0.005 or a thousandth of deltaE2000() of
// core/spectra/colorimetry.h, whichever is more, for colours whose parts are from −0.2 to 4; 1920 ×
// 1080 pixels take some 30 ms on two cores. The same bytes for any number of threads.
//
// Thread-safe: pure functions.

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/render/skin_samples.h"

namespace cutis {

// One channel; present where both pictures are. Precondition: both have three channels and the same
// size. NaN where a channel is.
Result<PictureBuffer> colorDifference(const PictureBuffer& a, const PictureBuffer& b,
                                      const JobContext& context);

// |b − a| of the first channel. Precondition: both have the same size.
PictureBuffer absoluteDifference(const PictureBuffer& a, const PictureBuffer& b);

}  // namespace cutis
