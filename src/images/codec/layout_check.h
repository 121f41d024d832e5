#pragma once  // internal to src/images/codec

// Whether a picture is laid out in a way that is read, found out before any of it is.

#include <cstdint>
#include <string>

#include <OpenImageIO/imageio.h>

#include "core/base/result.h"

namespace cutis {

// Whether a picture of this size is beyond the limits of image_reader.h.
bool exceedsLimits(std::int64_t width, std::int64_t height);

// An input error for deep and empty pictures, volumes, and what exceeds the limits.
Status checkLayout(const OIIO::ImageSpec& spec, const std::string& place);

}  // namespace cutis
