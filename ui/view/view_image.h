#pragma once

// Parts of views as images for the screen.

#include <optional>

#include <QImage>

#include "src/app/views/view_part.h"
#include "ui/color/color_scale.h"
#include "ui/color/display_curve.h"
#include "ui/color/display_range.h"

namespace cutis {

// Linear Rec.709 as the curve shows it; pixels without an estimate are hatched. RGB32.
QImage colorImage(const PictureBuffer& picture,
                  const DisplayCurve& curve = DisplayCurve::neutral());
// As if no pixel had an estimate: hatched all over.
QImage maskedImage(const ViewPart& part);
// One channel through a scale. RGB32.
QImage falseColorImage(const ViewPart& part, ScaleKind scale, const DisplayRange& range);

// The range from 0 to a round number just above nearly all values (99.5 %) of a part; none where no
// pixel of it has an estimate.
std::optional<DisplayRange> rangeOf(const ViewPart& part);

}  // namespace cutis
