#pragma once  // internal to src/images/preview

// What of an open picture its first impression is made of.

#include <optional>

#include "src/images/codec/image_reader.h"
#include "src/images/image_layers.h"
#include "src/images/preview/preview_canvas.h"

namespace cutis {

// How much the longer side can be reduced, a power of two, and still have as many pixels.
int reductionOf(int longerSide, int leastSide);

// Nothing for a layer without colours that is not grey, and where pixels are stored as other
// colours than R, G and B.
std::optional<CanvasLayout> canvasLayout(const ImagePart& part, const ImageLayer& layer, int step);

// In what rows of the part are read.
RowSamples rowSamples(const ImagePart& part);

}  // namespace cutis
