#pragma once  // internal to src/color

// Colour spaces of curves and a matrix.

#include <memory>
#include <string>

#include "src/color/color_space.h"

namespace cutis {

// A matrix below this is taken for one without an inverse.
inline constexpr double kLeastDeterminant = 1e-6;

// Precondition: the matrix has an inverse.
ColorSpace matrixSpace(std::string name, ColorMatrix matrix);

// The built-in space that means the same to within the rounding of profiles; none: an empty space.
ColorSpace builtInLike(const ColorSpace& space);

}  // namespace cutis
