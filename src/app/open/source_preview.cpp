#include "src/app/open/source_preview.h"

#include <cmath>
#include <utility>

#include "src/images/capture/capture_file.h"
#include "src/images/preview/image_preview.h"

namespace cutis {

std::optional<SourcePreview> previewSource(const std::filesystem::path& path,
                                           const SourceOptions& options,
                                           const JobContext& context) {
  if (looksLikeCapture(path)) return std::nullopt;
  auto image = previewImage(path, {options.colorSpace, options.layer}, context);
  if (!image) return std::nullopt;
  SourcePreview preview;
  preview.width = image->width;
  preview.height = image->height;
  preview.step = image->step;
  preview.picture.width = image->columns;
  preview.picture.height = image->rows;
  preview.picture.present.assign(image->colors.front().size(), true);
  for (std::vector<float>& channel : image->colors) {
    for (float& value : channel)
      value = std::isfinite(value) ? value : 0.0f;
    preview.picture.channels.push_back(std::move(channel));
  }
  return preview;
}

}  // namespace cutis
