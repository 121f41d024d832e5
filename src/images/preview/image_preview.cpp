#include "src/images/preview/image_preview.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/base/parallel.h"
#include "src/images/image_file.h"
#include "src/images/preview/reduced_jpeg.h"

namespace cutis {
namespace {

constexpr std::size_t kRowsAtOnce = 64;

// How much the longer side can be reduced and still have as many pixels.
int reductionOf(int longerSide, int leastSide) {
  int reduction = 8;
  while (reduction > 1 && longerSide / reduction < leastSide)
    reduction /= 2;
  return reduction;
}

// Some rows of samples as linear colours, interleaved. Grey counts as equal red, green and blue.
Status convertRows(const ReducedJpeg& image, const ColorConverter& toLinear, std::size_t first,
                   std::size_t count, std::vector<float>& rgb) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t width = static_cast<std::size_t>(image.width);
  rgb.resize(3 * count * width);
  for (std::size_t p = 0; p < count * width; ++p) {
    const std::uint8_t* sample = &image.samples[(first * width + p) * channels];
    for (std::size_t c = 0; c < 3; ++c)
      rgb[3 * p + c] = static_cast<float>(sample[channels == 1 ? 0 : c]) / 255.0f;
  }
  return toLinear(rgb);
}

Result<std::array<std::vector<float>, 3>> linearColors(const ReducedJpeg& image,
                                                       const ColorConverter& toLinear,
                                                       const JobContext& context) {
  const auto width = static_cast<std::size_t>(image.width);
  const auto height = static_cast<std::size_t>(image.height);
  std::array<std::vector<float>, 3> colors;
  for (std::vector<float>& channel : colors)
    channel.resize(width * height);
  const std::size_t pieces = (height + kRowsAtOnce - 1) / kRowsAtOnce;
  CUTIS_CHECK(parallelFor(pieces, {context.stop, {}, {}}, [&](std::size_t i) -> Status {
    const std::size_t first = i * kRowsAtOnce;
    const std::size_t count = std::min(kRowsAtOnce, height - first);
    std::vector<float> rgb;
    CUTIS_CHECK(convertRows(image, toLinear, first, count, rgb));
    for (std::size_t p = 0; p < count * width; ++p) {
      for (std::size_t c = 0; c < 3; ++c)
        colors[c][first * width + p] = rgb[3 * p + c];
    }
    return {};
  }));
  return colors;
}

std::optional<ImagePreview> reducedPreview(const ImageHeader& header, const PreviewOptions& options,
                                           const JobContext& context) {
  const int reduction = reductionOf(std::max(header.width, header.height), options.leastSide);
  const auto decision = decideColors(header.colors, options.colorSpace, header.file.string());
  if (reduction == 1 || !decision) return std::nullopt;
  const auto image = readReducedJpeg(header.file, reduction, context);
  if (!image) return std::nullopt;
  const auto colors = linearColors(*image, decision.value().followed.space.toLinearRec709, context);
  if (!colors) return std::nullopt;
  ImagePreview preview;
  preview.width = header.width;
  preview.height = header.height;
  preview.step = reduction;
  const bool isTurned = swapsSides(header.orientation);
  preview.columns = isTurned ? image->height : image->width;
  preview.rows = isTurned ? image->width : image->height;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::vector<float>& stored = colors.value()[c];
    preview.colors[c].resize(stored.size());
    turnUpright(stored, image->width, image->height, header.orientation, preview.colors[c]);
  }
  return preview;
}

}  // namespace

std::optional<ImagePreview> previewImage(const std::filesystem::path& path,
                                         const PreviewOptions& options, const JobContext& context) {
  const JobContext silent = {context.stop, {}, {}};
  const auto header = readImageHeader(path, silent, options.layer);
  // Inks and the like are converted by what reads the whole picture.
  if (!header || header.value().kind != ImageFileKind::jpeg || header.value().colors.isConverted)
    return std::nullopt;
  return reducedPreview(header.value(), options, silent);
}

}  // namespace cutis
