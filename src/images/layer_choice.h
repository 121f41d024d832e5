#pragma once

// Layers of an open file, and which of them is meant.

#include <string>
#include <vector>

#include "src/images/codec/image_reader.h"
#include "src/images/image_layers.h"

namespace cutis {

Result<std::vector<ImageLayer>> layersOf(ImageReader& reader);

struct LayerChoice {
  ImageLayer layer;
  std::vector<ImageLayer> others;  // that could be meant as well
};

// Without a name the first with plain R, G and B, else the first with colours, else the first of
// all. An input error that lists what there is for a name that is none.
Result<LayerChoice> chooseLayer(const std::vector<ImageLayer>& layers, const std::string& name,
                                const std::string& place);

}  // namespace cutis
