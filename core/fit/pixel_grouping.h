#pragma once  // internal to core/fit

// Finds equal pixels, so that each is solved once: 8-bit textures repeat their colours heavily.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/pixel_rows.h"

namespace cutis {

struct PixelGrouping {
  std::vector<std::uint32_t> representatives;  // pixels to solve, increasing
  std::vector<std::uint32_t> groupOf;          // per pixel handed in: index into representatives
};

// pixels: which of them to group, increasing. Equal means the same bits in every channel. Where a
// sample of the pixels shows hardly any repetition every pixel is its own group: looking for equals
// would cost more than it saves. reused: a grouping whose memory may be taken.
PixelGrouping groupEqualPixels(PixelRows<const float> channels,
                               const std::vector<std::uint32_t>& pixels, PixelGrouping reused = {});

}  // namespace cutis
