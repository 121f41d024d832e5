#pragma once

// The photograph itself, part by part, in the colours of the other pictures.

#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/render/render_picture.h"
#include "src/app/open/source.h"

namespace cutis {

// Every step-th pixel of every step-th row of rect: three channels, linear Rec.709, all present;
// under a light of the rig, whose colours are matched as those of the first. Without the exposure.
// Not finite values read as 0.
Result<PictureBuffer> photographPart(const Source& source, const Rect& rect, int step,
                                     int light = 0);

}  // namespace cutis
