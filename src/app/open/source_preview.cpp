#include "src/app/open/source_preview.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "src/images/capture/capture_file.h"

namespace cutis {
namespace {

SourcePreview sourcePreview(ImagePreview image) {
  SourcePreview preview;
  preview.width = image.width;
  preview.height = image.height;
  preview.step = image.step;
  preview.picture.width = image.columns;
  preview.picture.height = image.rows;
  std::vector<float>& red = image.colors.front();
  preview.picture.present.resize(red.size());
  std::transform(red.begin(), red.end(), preview.picture.present.begin(),
                 [](float value) { return !std::isnan(value); });
  for (std::vector<float>& channel : image.colors)
    preview.picture.channels.push_back(std::move(channel));
  return preview;
}

}  // namespace

PreviewSink previewSink(const SourceOptions& options,
                        std::function<void(SourcePreview preview)> show) {
  return {{options.colorSpace, options.layer},
          [show = std::move(show)](ImagePreview image) { show(sourcePreview(std::move(image))); }};
}

bool showSource(const std::filesystem::path& path, const PreviewSink& sink,
                const JobContext& context) {
  if (looksLikeCapture(path)) return false;
  auto image = previewImage(path, sink.options, context);
  if (!image) return false;
  sink.show(*std::move(image));
  return true;
}

}  // namespace cutis
