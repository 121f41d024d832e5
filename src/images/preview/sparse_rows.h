#pragma once  // internal to src/images/preview

// Some of a picture's rows, evenly spread over it, where a file gives them without those before.

#include <cstdint>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/images/codec/image_reader.h"
#include "src/images/preview/preview_canvas.h"

namespace cutis {

struct SparseRows {
  int count = 0;    // at once: whole strips, rows of tiles or compressed blocks
  int spacing = 0;  // from the first of them to the first of the next; a multiple of count

  bool empty() const { return count == 0; }
};

// At least `least` rows at once, and no more bytes of samples in all than `mostBytes`; empty if
// that would be too few to be seen.
SparseRows chooseRows(const ImagePart& part, ImageFileKind kind, int least, std::int64_t mostBytes);

// Reads them into the canvas, on all cores.
Status readSparsely(const std::filesystem::path& path, const ImagePart& part,
                    const SparseRows& rows, PreviewCanvas& canvas, const JobContext& context);

}  // namespace cutis
