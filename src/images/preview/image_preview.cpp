#include "src/images/preview/image_preview.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "src/images/codec/image_reader.h"
#include "src/images/color/file_colors.h"
#include "src/images/inputs/tiff_check.h"
#include "src/images/layer_choice.h"
#include "src/images/preview/preview_layout.h"
#include "src/images/preview/reduced_jpeg.h"
#include "src/images/preview/smaller_version.h"
#include "src/images/preview/sparse_rows.h"

namespace cutis {
namespace {

constexpr int kMostJpegReduction = 8;
// Samples that are decoded for a first impression. Rows of tiles are high, and what is filled in
// between them is seen.
constexpr std::int64_t kMostBytesOfRows = std::int64_t{64} << 20;
constexpr std::int64_t kMostBytesOfTiles = std::int64_t{128} << 20;

// What is to be seen of an open file.
struct Subject {
  ImagePart part;
  ImageLayer layer;
  ColorConverter toLinear;
  int reduction = 1;
};

// Nothing where reading all of it would fail, or would convert its colours in another way.
std::optional<Subject> subjectOf(ImageReader& reader, const std::filesystem::path& path,
                                 const PreviewOptions& options) {
  const auto layers = layersOf(reader);
  if (!layers) return std::nullopt;
  auto chosen = chooseLayer(layers.value(), options.layer, reader.place());
  if (!chosen) return std::nullopt;
  ImageLayer& layer = chosen.value().layer;
  auto part = reader.part(layer.part);
  if (!part || !reader.includeOverscan(part.value())) return std::nullopt;
  const FileColors colors = fileColors(path, reader.kind(), part.value());
  const auto decision = decideColors(colors, options.colorSpace, reader.place());
  const bool isMeant = layer.colors || layers.value().size() == 1 || !options.layer.empty();
  if (!isMeant || !decision || colors.isConverted) return std::nullopt;
  Subject subject;
  subject.part = std::move(part.value());
  subject.layer = std::move(layer);
  subject.toLinear = decision.value().followed.space.toLinearRec709;
  const Rect& window = subject.part.window;
  subject.reduction = reductionOf(std::max(window.width(), window.height()), options.leastSide);
  return subject;
}

// Whether files of this kind give a first impression without being read from end to end.
bool isSeenBefore(ImageFileKind kind) {
  return kind == ImageFileKind::jpeg || kind == ImageFileKind::openExr ||
         kind == ImageFileKind::tiff;
}

// As a picture of the whole size, of which this is a smaller version.
ImagePreview asVersionOf(const ImagePart& whole, int reduction, ImagePreview preview) {
  preview.width = whole.width();
  preview.height = whole.height();
  preview.step *= reduction;
  return preview;
}

std::optional<ImagePreview> jpegPreview(const std::filesystem::path& path, const Subject& subject,
                                        const JobContext& context) {
  const int reduction = std::min(subject.reduction, kMostJpegReduction);
  const auto image = readReducedJpeg(path, reduction, context);
  if (!image) return std::nullopt;
  CanvasLayout layout;
  layout.window = {0, 0, image->width, image->height};
  layout.stored = layout.window;
  layout.orientation = subject.part.orientation;
  layout.channels = image->channels;
  if (image->channels == 1) layout.colors = {0, 0, 0};
  PreviewCanvas canvas(layout, subject.toLinear);
  canvas.add(RowSamples::bytes, std::as_bytes(std::span(image->samples)), 0);
  auto preview = canvas.picture(PreviewCanvas::Gaps::empty, context);
  if (!preview) return std::nullopt;
  return asVersionOf(subject.part, reduction, *std::move(preview));
}

std::optional<ImagePreview> sparsePreview(const std::filesystem::path& path, ImageReader& reader,
                                          const Subject& subject, const PreviewOptions& options,
                                          const JobContext& context) {
  if (reader.kind() == ImageFileKind::tiff && !checkTiffExtent(path)) return std::nullopt;
  const auto smaller = smallerVersion(reader, subject.part, options.leastSide);
  const ImagePart& part = smaller ? smaller->part : subject.part;
  const int step =
      reductionOf(std::max(part.window.width(), part.window.height()), options.leastSide);
  const auto layout = canvasLayout(part, subject.layer, step);
  const std::int64_t mostBytes = part.spec.tile_width > 0 ? kMostBytesOfTiles : kMostBytesOfRows;
  const SparseRows rows = chooseRows(part, reader.kind(), step, mostBytes);
  if (!layout || rows.empty()) return std::nullopt;
  PreviewCanvas canvas(*layout, subject.toLinear);
  if (!readSparsely(path, part, rows, canvas, context)) return std::nullopt;
  auto preview = canvas.picture(PreviewCanvas::Gaps::filled, context);
  if (!preview) return std::nullopt;
  return asVersionOf(subject.part, smaller ? smaller->reduction : 1, *std::move(preview));
}

}  // namespace

std::optional<ImagePreview> previewImage(const std::filesystem::path& path,
                                         const PreviewOptions& options, const JobContext& context) {
  const auto kind = identifyImageFile(path);
  // Some of the others are decoded as a whole when they are opened.
  if (!kind || !isSeenBefore(kind.value())) return std::nullopt;
  const JobContext silent = {context.stop, {}, {}};
  auto reader = ImageReader::open(path, silent);
  if (!reader) return std::nullopt;
  const auto subject = subjectOf(reader.value(), path, options);
  if (!subject || subject->reduction == 1) return std::nullopt;
  if (kind.value() == ImageFileKind::jpeg) return jpegPreview(path, *subject, silent);
  return sparsePreview(path, reader.value(), *subject, options, silent);
}

}  // namespace cutis
