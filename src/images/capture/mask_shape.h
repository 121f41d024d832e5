#pragma once  // internal to src/images/capture

// Where in a picture the shape of a mask is: in its alpha, in one colour, or in its luminance.

#include <vector>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"

namespace cutis {

// Straight colours, one or three, and alpha.
struct MaskChannels {
  std::vector<Plane> colors;
  Plane alpha;  // may be empty
};

enum class MaskShape { none, alpha, oneColor, luminance };

struct FoundMask {
  MaskShape shape = MaskShape::none;
  bool colorsDiffer = false;  // alpha was taken, and the colours hold another shape
  bool isColored = false;     // luminance was taken of colours that are not grey
  bool isEmpty = false;       // 0 everywhere
  bool isFull = false;        // 1 everywhere
};

// Writes the mask's values, in [0, 1], into a plane of the same size.
Result<FoundMask> findMask(const MaskChannels& channels, Plane& mask, const JobContext& context);

}  // namespace cutis
