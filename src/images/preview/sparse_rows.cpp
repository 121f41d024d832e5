#include "src/images/preview/sparse_rows.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "src/images/preview/preview_layout.h"

namespace cutis {
namespace {

constexpr int kFewestPieces = 12;

// Rows that OpenEXR compresses as one (OpenEXR file layout, "Scan line blocks").
int exrBlockRows(const std::string& compression) {
  if (compression == "zip" || compression == "pxr24") return 16;
  if (compression == "piz" || compression.starts_with("b44") || compression.starts_with("dwaa"))
    return 32;
  return compression.starts_with("dwab") ? 256 : 1;
}

// Rows that are decoded together. 0: not known.
int blockRows(const ImagePart& part, ImageFileKind kind) {
  const OIIO::ImageSpec& spec = part.spec;
  if (spec.tile_width > 0) return spec.tile_height;
  if (kind == ImageFileKind::openExr)
    return exrBlockRows(std::string(spec.get_string_attribute("compression")));
  return spec.get_int_attribute("tiff:RowsPerStrip");
}

}  // namespace

SparseRows chooseRows(const ImagePart& part, ImageFileKind kind, int least,
                      std::int64_t mostBytes) {
  const int height = part.stored.height();
  const int block = std::min(blockRows(part, kind), height);
  if (block <= 0) return {};
  const int count = std::min((least + block - 1) / block * block, height);
  const auto rowBytes = static_cast<std::int64_t>(part.spec.scanline_bytes(true));
  const std::int64_t pieces = (height + count - 1) / count;
  const std::int64_t affordable = mostBytes / std::max<std::int64_t>(1, count * rowBytes);
  if (affordable < std::min<std::int64_t>(pieces, kFewestPieces)) return {};
  const std::int64_t every = (pieces + affordable - 1) / affordable;
  return {count, static_cast<int>(every) * count};
}

Status readSparsely(const std::filesystem::path& path, const ImagePart& part,
                    const SparseRows& rows, PreviewCanvas& canvas, const JobContext& context) {
  const Rect& stored = part.stored;
  const int pieces = (stored.height() + rows.spacing - 1) / rows.spacing;
  const RowSamples samples = rowSamples(part);
  const std::size_t rowBytes = static_cast<std::size_t>(stored.width()) *
                               static_cast<std::size_t>(part.storedChannels) * rowType(part).size();
  std::atomic<int> next = 0;
  // A reader belongs to one thread.
  const auto readers = static_cast<std::size_t>(std::min(parallelThreadCount(), pieces));
  return parallelFor(readers, {context.stop, {}, {}}, [&](std::size_t) -> Status {
    CUTIS_TRY(reader, ImageReader::open(path, {context.stop, {}, {}}));
    std::vector<std::byte> buffer(static_cast<std::size_t>(rows.count) * rowBytes);
    for (int piece = next++; piece < pieces; piece = next++) {
      if (context.stopRequested()) return Cancelled{};
      const int y0 = stored.y0 + piece * rows.spacing;
      const int y1 = std::min(stored.y1, y0 + rows.count);
      CUTIS_CHECK(reader.readRows(part, y0, y1, buffer.data()));
      canvas.add(samples, std::span(buffer).first(static_cast<std::size_t>(y1 - y0) * rowBytes),
                 y0);
    }
    return {};
  });
}

}  // namespace cutis
