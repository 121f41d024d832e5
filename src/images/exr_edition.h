#pragma once  // internal to src/images

// A new edition of an OpenEXR file: with other colours in one layer, and everything else as it was.
//
// Data and display window, parts, channels with their types, tiles and smaller levels are those of
// the source, which is read again while it is written. Smaller levels change by what their pixels
// change on average. What OpenImageIO cannot write is left out with a notice: deep parts, tiles and
// levels in a file of several parts of which not all are tiled, and levels in two directions.

#include <filesystem>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/images/codec/image_writer.h"
#include "src/images/image_file.h"

namespace cutis {

struct ExrEdition {
  std::vector<OutputPart> parts;
  std::vector<OIIO::ImageSpec> plain;  // the same specs without what was carried over
  std::shared_ptr<std::size_t> clipped = std::make_shared<std::size_t>(0);  // pixels so far
};

// spec, plain: of the picture's part, with and without metadata, as they would be for a new file.
// Precondition: the content has a source that is OpenEXR, with colours in its layer. `place` is the
// name of the output in notices. Fails with a sentence if the source cannot be read any more.
Result<ExrEdition> makeExrEdition(const ImageContent& content, const OIIO::ImageSpec& spec,
                                  const OIIO::ImageSpec& plain, SampleType type,
                                  const std::string& place, const JobContext& context);

}  // namespace cutis
