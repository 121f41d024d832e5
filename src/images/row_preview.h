#pragma once

// A picture seen while its rows are read one after the other: src/images/preview/row_preview.cpp.

#include "src/images/codec/image_reader.h"
#include "src/images/color/color_statement.h"
#include "src/images/image_layers.h"

namespace cutis {

struct PreviewSink;

// What ImageReader::read() calls with the rows; shows them at once, and then as often as people
// notice. Empty where there is nothing to see of the picture before it is read. `sink` outlives it.
RowsSeen rowPreview(const ImagePart& part, const ImageLayer& layer, const FileColors& colors,
                    const PreviewSink& sink, const JobContext& context);

}  // namespace cutis
