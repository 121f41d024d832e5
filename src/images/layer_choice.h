#pragma once

// Layers of an open file, and which of them is meant.

#include "src/images/codec/image_reader.h"
#include "src/images/image_layers.h"

namespace cutis {

Result<std::vector<ImageLayer>> layersOf(ImageReader& reader);

// The layer of this name; empty: the first with plain R, G and B, else the first of all, which may
// have no colours. An input error that lists what there is for a name that is none.
Result<ImageLayer> chooseLayer(const std::vector<ImageLayer>& layers, const std::string& name,
                               const std::string& place);

}  // namespace cutis
