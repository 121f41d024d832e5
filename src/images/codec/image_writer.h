#pragma once

// A picture file being written, part by part. For the files of this folder.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "src/images/codec/output_file.h"
#include "src/images/codec/sample_type.h"
#include "src/images/codec/source_file.h"

namespace cutis {

// What is done to colours on their way into the file.
enum class AlphaStep { none, multiply, divide };

struct OutputPart {
  OIIO::ImageSpec spec;         // complete, with its channels' names
  std::vector<Plane> channels;  // one per channel of the spec
  AlphaStep alphaStep = AlphaStep::none;
  Plane alpha = {};            // by which it is done
  std::size_t colorCount = 0;  // the first of the channels, which it is done to

  // Instead of channels: fills in rows [y0, y1) of a level, in the file's own coordinates and each
  // channel in the type that the spec gives it. Called for all rows in order, level by level.
  std::function<Status(int level, int y0, int y1, std::vector<std::byte>& rows)> nativeRows = {};
  // Smaller versions, from the largest on.
  std::vector<OIIO::ImageSpec> levels = {};
};

// What did not fit, counted while it was written.
struct WriteLosses {
  std::size_t clipped = 0;       // pixels with a value beyond what the samples hold
  std::size_t noNumbers = 0;     // pixels with NaN, which integers do not have
  std::size_t hiddenColors = 0;  // pixels of alpha 0 with a colour that could not be multiplied
};

// Writes to `file`, a temporary of writeAtomically; `place` is the name that errors give. What the
// file cannot keep of the metadata must not keep it from being written: if the header is refused,
// `plain` is tried, the same specs without what was carried over, and said in a notice.
// inserted: what is put behind the head of a PNG or JPEG file (src/images/color/output_colors.h).
Result<WriteLosses> writeParts(const std::filesystem::path& file, const std::string& place,
                               ImageFileKind kind, SampleType type,
                               const std::vector<OutputPart>& parts,
                               const std::vector<OIIO::ImageSpec>& plain,
                               const std::string& inserted, const JobContext& context);

}  // namespace cutis
