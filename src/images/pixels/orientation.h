#pragma once

// How a picture lies in its file: cameras store what the sensor saw and say in a tag how to turn
// it.
//
// The numbers are those of the EXIF and TIFF tag Orientation. Pictures are turned once, while they
// are read, and written upright. Thread-safe: pure functions.

#include <span>

#include "core/base/rect.h"

namespace cutis {

enum class Orientation {
  upright = 1,
  mirrored = 2,        // left and right are exchanged
  upsideDown = 3,      // turned by 180°
  flipped = 4,         // top and bottom are exchanged
  transposed = 5,      // rows are columns
  lyingLeft = 6,       // to be turned clockwise by 90°
  antiTransposed = 7,  // rows are columns, both from their ends
  lyingRight = 8,      // to be turned counterclockwise by 90°
};

// Upright for numbers that are none.
Orientation orientationOf(int tag);

// Whether width and height are exchanged.
bool swapsSides(Orientation orientation);

// Where a part of a stored picture of width × height lies once that stands upright.
Rect uprightRect(const Rect& stored, int width, int height, Orientation orientation);

// The pixels of a stored part of width × height, row by row, to those of the same part upright.
// Precondition: both have width · height values.
void turnUpright(std::span<const float> stored, int width, int height, Orientation orientation,
                 std::span<float> upright);

}  // namespace cutis
