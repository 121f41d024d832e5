#pragma once

// A picture at the resolution of the screen: the mean of the texels that a pixel of it covers.

#include "core/render/skin_samples.h"

namespace cutis {

// Each pixel is the mean of a block of step × step pixels, cut at the right and lower edge; of
// pixels without an estimate it has none, and where some of a block have one it is their mean.
// Channels are means in their own, linear scale. For pictures of light alone: concentrations are
// never averaged, as the mean skin has not the mean colour.
PictureBuffer boxAverage(const PictureBuffer& picture, int step);

}  // namespace cutis
