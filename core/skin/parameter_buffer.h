#pragma once

// Parameters of a rectangle of pixels in memory: what edits change and kernels read.

#include <array>
#include <span>
#include <vector>

#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/skin/chromophore_maps.h"
#include "core/skin/model/reflectance_batch.h"

namespace cutis {

struct ParameterBuffer {
  // Indexed by Parameter; all of one length, row by row.
  std::array<std::vector<float>, kParameterCount> values;
  // Indexed by SkinConstant; empty where the profile's holds. Edits leave them alone.
  std::array<std::vector<float>, kConstantCount> constants;
  // Whether the pixel has an estimate.
  std::vector<bool> present;

  std::size_t count() const { return present.size(); }
  ParameterBatch<float> batch() const;
};

// Every `step`-th pixel of every `step`-th row of rect, from its upper left corner: the width of
// the result is ⌈width / step⌉. Precondition: rect lies within the maps.
Result<ParameterBuffer> loadParameters(const ChromophoreMaps& maps, const Rect& rect, int step = 1);

// Writes the parameters of a buffer loaded with step 1 back into a rectangle of maps of the same
// size.
Status storeParameters(const ParameterBuffer& buffer, const Rect& rect, ChromophoreMaps& maps);

}  // namespace cutis
