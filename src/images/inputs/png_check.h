#pragma once

// Whether a PNG file is whole.
//
// libpng reports a damaged file on stderr besides returning an error; looking at the chunks first
// keeps the one line there that belongs to us.

#include <filesystem>

#include "core/base/job_context.h"
#include "core/base/result.h"

namespace cutis {

enum class PngExtent { beforePixels, whole };

// Walks the chunks and checks their lengths and checksums (PNG specification, §5.3), to the end or
// to where the pixels begin. Precondition: the file begins like a PNG.
Status checkPngChunks(const std::filesystem::path& path, PngExtent extent,
                      const JobContext& context);

}  // namespace cutis
