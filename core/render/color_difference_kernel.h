#pragma once  // internal to core/render

// Vectorised part of core/render/color_difference.cpp. Plain data.

#include <array>
#include <cstddef>

namespace cutis {

struct ColorDifferenceArguments {
  std::array<const float*, 3> a, b;           // linear, count of each
  std::array<std::array<float, 3>, 3> toXyz;  // relative to the white
  float* out;
  std::size_t count;
};

void runColorDifferenceKernel(const ColorDifferenceArguments& arguments);

}  // namespace cutis
