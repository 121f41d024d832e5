#pragma once

// Small photographs for the tests of whole-picture fits.

#include <functional>
#include <vector>

#include "core/fit/fit_run.h"
#include "core/rig/measurements.h"

namespace cutis::test {

// channels(x, y) gives the rig's channels of a pixel; state(x, y) what is known of it before a fit.
Measurements photograph(const Rig& rig, int width, int height,
                        const std::function<std::vector<float>(int, int)>& channels,
                        const std::function<PixelState(int, int)>& state = {});

// Skin that differs from pixel to pixel by 1 %: no two are equal.
Measurements skinPhotograph(const Rig& rig, int width, int height);

// The same pixels, from `part` of the picture alone.
Measurements crop(const Measurements& picture, const Rect& part);

std::vector<float> pixelsOf(const Plane& plane, const Rect& rect);
std::vector<float> pixelsOf(const Plane& plane);

// Every plane of a result within rect, one after the other.
std::vector<float> everything(const FitPlanes& planes, const Rect& rect);

}  // namespace cutis::test
