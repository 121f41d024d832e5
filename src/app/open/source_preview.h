#pragma once

// What can be shown of a source long before it is read.

#include <filesystem>
#include <functional>

#include "core/base/job_context.h"
#include "core/render/skin_samples.h"
#include "src/app/open/source.h"
#include "src/images/preview/image_preview.h"

namespace cutis {

struct SourcePreview {
  // The size of the whole picture, in pixels.
  int width = 0;
  int height = 0;
  // All of it, in the colours of photographPart(), a sample for each step × step pixels; present
  // where it was read.
  int step = 1;
  PictureBuffer picture;
};

// For openSource() with these options.
PreviewSink previewSink(const SourceOptions& options,
                        std::function<void(SourcePreview preview)> show);

// Shows what previewImage() has of it, captures excepted. Whether there was something.
bool showSource(const std::filesystem::path& path, const PreviewSink& sink,
                const JobContext& context);

}  // namespace cutis
