#pragma once  // internal to core/skin

// Vectorised part of core/skin/response_table.cpp. Plain data, see layers/node_constants.h.

#include <cstddef>
#include <cstdint>

#include "core/base/pixel_rows.h"
#include "core/skin/profile/parameter.h"

namespace cutis {

struct ResponseTableAxis {
  float inverseMaximum;
  float intervals;      // samples − 1
  int exponent;         // 1, 2 or 3
  std::int32_t stride;  // in floats
};

struct ResponseTableArguments {
  const float* samples;
  ResponseTableAxis axes[kParameterCount];
  PixelRows<const float> parameters;
  std::size_t rowCount;  // of the response
  float* const* out;     // [row][pixel]
};

void runResponseTableKernel(const ResponseTableArguments& arguments);

}  // namespace cutis
