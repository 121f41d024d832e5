#pragma once

// What can be shown of a source long before it is read.

#include <filesystem>
#include <optional>

#include "core/base/job_context.h"
#include "core/render/skin_samples.h"
#include "src/app/open/source.h"

namespace cutis {

struct SourcePreview {
  // Of the whole picture, in pixels.
  int width = 0;
  int height = 0;
  // All of it, in the colours of photographPart(), a sample for each step × step pixels.
  int step = 1;
  PictureBuffer picture;
};

// Nothing for captures and where previewImage() has nothing.
std::optional<SourcePreview> previewSource(const std::filesystem::path& path,
                                           const SourceOptions& options, const JobContext& context);

}  // namespace cutis
