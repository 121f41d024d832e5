#pragma once

// A rectangle of a plane at the resolution of a screen.

#include <cstddef>
#include <span>

#include "core/base/plane.h"
#include "core/base/rect.h"
#include "core/base/result.h"

namespace cutis {

// How many pixels every step-th pixel of every step-th row of a rectangle are.
std::size_t sampleCount(const Rect& rect, int step);

// Loads them, row by row from its upper left corner, a row of the plane in memory at a time. out:
// sampleCount() values. Precondition and errors: those of Plane::load().
Status loadSampled(const Plane& plane, const Rect& rect, int step, std::span<float> out);

}  // namespace cutis
