#pragma once  // internal to src/images/codec

// Samples that do not mean what they would at first sight, made to mean it while they are read:
// white at 0, factors, and colours that are not stored as R, G and B.
//
// Thread-safe: pure functions.

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"
#include "src/images/codec/image_reader.h"

namespace cutis {

// Whether 0 is white and OpenImageIO leaves it so, as it does beyond 8 bits.
bool hasWhiteAtZero(ImageFileKind kind, const OIIO::ImageSpec& spec);

// SGI's logarithmic colours, of which OpenImageIO would make 8 bits without saying so.
bool isLogLuv(ImageFileKind kind, const OIIO::ImageSpec& spec);

// The channels of luminance and chroma without a layer, of full resolution.
bool isWholeLumaChroma(const OIIO::ImageSpec& spec);

// Turns rows of `count` samples of a part, as rowType() has them, into what they mean.
void giveMeaning(const ImagePart& part, std::byte* rows, std::size_t count);

// R, G and B in place of the stored colours, which are the first planes.
Result<std::vector<Plane>> convertColors(const StoredColors& colors, std::vector<Plane> stored,
                                         const std::shared_ptr<TileStore>& store,
                                         const JobContext& context);

}  // namespace cutis
