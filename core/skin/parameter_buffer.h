#pragma once

// Parameters of a rectangle of pixels in memory: what edits change and kernels read.

#include <cstddef>
#include <vector>

#include "core/base/pixel_rows.h"
#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/skin/chromophore_maps.h"

namespace cutis {

struct ParameterBuffer {
  // A row per parameter, then one per constant that is found for each pixel, in the order of
  // SkinConstant, then one per coefficient of the discrepancy; edits leave these alone. Pixels row
  // by row of the picture.
  PixelBuffer<float> values;
  // Whether the pixel has an estimate.
  std::vector<bool> present;

  std::size_t count() const { return present.size(); }
  PixelRows<const float> batch() const { return values.rows(); }
};

// Every `step`-th pixel of every `step`-th row of rect, from its upper left corner: the width of
// the result is ⌈width / step⌉. Precondition: rect lies within the maps.
Result<ParameterBuffer> loadParameters(const ChromophoreMaps& maps, const Rect& rect, int step = 1);

// Writes the parameters of a buffer loaded with step 1 back into a rectangle of maps of the same
// size.
Status storeParameters(const ParameterBuffer& buffer, const Rect& rect, ChromophoreMaps& maps);

}  // namespace cutis
