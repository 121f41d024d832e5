#pragma once

// A first impression of a picture, long before all of it is read: of a JPEG, whose transform gives
// it at a fraction of the work.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job_context.h"

namespace cutis {

struct ImagePreview {
  // Of the whole picture, upright.
  int width = 0;
  int height = 0;
  int step = 1;  // each pixel of the preview stands for step × step of these
  int columns = 0;
  int rows = 0;
  std::array<std::vector<float>, 3> colors;  // linear Rec.709, row by row
};

struct PreviewOptions {
  std::string colorSpace;  // empty: what the file says, as for the whole picture
  std::string layer;
  int leastSide = 1024;  // the longer side has at least as many pixels, if the picture has
};

// In the colours in which the whole picture will be read. Nothing for other formats, for pictures
// that are small anyway, and where anything is wrong: reading the whole picture says what.
std::optional<ImagePreview> previewImage(const std::filesystem::path& path,
                                         const PreviewOptions& options, const JobContext& context);

}  // namespace cutis
