#include "src/images/preview/preview_layout.h"

namespace cutis {

int reductionOf(int longerSide, int leastSide) {
  int reduction = 1;
  while (longerSide / (2 * reduction) >= leastSide)
    reduction *= 2;
  return reduction;
}

std::optional<CanvasLayout> canvasLayout(const ImagePart& part, const ImageLayer& layer, int step) {
  if (part.otherColors) return std::nullopt;
  CanvasLayout layout;
  layout.window = part.window;
  layout.stored = part.stored;
  layout.orientation = part.orientation;
  layout.channels = part.storedChannels;
  layout.step = step;
  const int grey = layer.prefix.empty() ? part.channelIndex("Y") : -1;
  if (layer.colors) {
    layout.colors = *layer.colors;
  } else if (grey >= 0) {
    layout.colors = {grey, grey, grey};
  } else {
    return std::nullopt;
  }
  if (part.alphaKind == AlphaKind::associated) layout.alpha = layer.alpha;
  return layout;
}

RowSamples rowSamples(const ImagePart& part) {
  const OIIO::TypeDesc type = rowType(part);
  if (type == OIIO::TypeUInt8) return RowSamples::bytes;
  return type == OIIO::TypeUInt16 ? RowSamples::words : RowSamples::floats;
}

}  // namespace cutis
