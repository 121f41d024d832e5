#pragma once

// A first impression of a picture, long before all of it is read.
//
// A JPEG's transform gives it at a fraction of the work; OpenEXR and TIFF files have smaller
// versions of it, or are read in some of their strips or rows of tiles, between which it is filled
// in. Pictures in other files are seen row by row as they are read. The first impression has the
// colours, the layer and the orientation in which the whole picture will be read.

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job_context.h"

namespace cutis {

struct ImagePreview {
  // The size of the whole picture, upright.
  int width = 0;
  int height = 0;
  int step = 1;  // each pixel of the preview stands for step × step of these
  int columns = 0;
  int rows = 0;
  // Linear Rec.709, row by row; finite, or NaN in all three of what was not read yet.
  std::array<std::vector<float>, 3> colors;
};

struct PreviewOptions {
  std::string colorSpace;  // empty: what the file says, as for the whole picture
  std::string layer;
  int leastSide = 1024;  // the longer side has at least as many pixels, if the picture has
};

// Who looks on while a picture is read.
struct PreviewSink {
  PreviewOptions options;
  // Called on the thread that reads, with more of the picture each time; the last time with all.
  std::function<void(ImagePreview preview)> show;
};

// Before anything else of the picture is read. Nothing for other formats, for pictures that are
// small anyway, and where anything is wrong: reading the whole picture says what.
std::optional<ImagePreview> previewImage(const std::filesystem::path& path,
                                         const PreviewOptions& options, const JobContext& context);

}  // namespace cutis
