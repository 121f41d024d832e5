#include "src/images/preview/preview_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/base/parallel.h"

namespace cutis {
namespace {

constexpr std::size_t kRowsAtOnce = 32;

std::size_t cellsOf(int pixels, int step) {
  return static_cast<std::size_t>((pixels + step - 1) / step);
}

template <typename Sample>
float valueOf(Sample sample) {
  if constexpr (std::is_floating_point_v<Sample>) {
    return std::isfinite(sample) ? sample : 0.0f;
  } else {
    constexpr float kUnit = 1.0f / static_cast<float>(std::numeric_limits<Sample>::max());
    return kUnit * static_cast<float>(sample);
  }
}

// Between the rows next to them, in place.
void fillGaps(const std::vector<char>& known, std::size_t columns, std::vector<float>& plane) {
  const std::size_t rows = known.size();
  for (std::size_t row = 0, before = rows; row < rows; ++row) {
    if (known[row]) {
      before = row;
      continue;
    }
    std::size_t after = row;
    while (after < rows && !known[after])
      ++after;
    const std::size_t above = before < rows ? before : after, below = after < rows ? after : above;
    if (above >= rows) return;
    const float share =
        above == below ? 0.0f : static_cast<float>(row - above) / static_cast<float>(below - above);
    for (std::size_t x = 0; x < columns; ++x) {
      plane[row * columns + x] =
          (1.0f - share) * plane[above * columns + x] + share * plane[below * columns + x];
    }
  }
}

}  // namespace

PreviewCanvas::PreviewCanvas(const CanvasLayout& layout, ColorConverter toLinear)
    : layout_(layout),
      toLinear_(std::move(toLinear)),
      columns_(cellsOf(layout.window.width(), layout.step)),
      rows_(cellsOf(layout.window.height(), layout.step)),
      sums_(3 * columns_ * rows_),
      rowsAdded_(rows_) {
  // What is not stored is known to be 0.
  const Rect &window = layout.window, &stored = layout.stored;
  for (int y = window.y0; y < window.y1; ++y) {
    const auto row = static_cast<std::size_t>((y - window.y0) / layout.step);
    if (y < stored.y0 || y >= stored.y1) ++rowsAdded_[row];
  }
}

int PreviewCanvas::rowsOf(std::size_t row) const {
  const int first = static_cast<int>(row) * layout_.step;
  return std::min(layout_.step, layout_.window.height() - first);
}

template <typename Sample>
void PreviewCanvas::addRow(const Sample* samples, float* sums) const {
  const Rect &window = layout_.window, &stored = layout_.stored;
  const auto channels = static_cast<std::ptrdiff_t>(layout_.channels);
  const int end = std::min(window.x1, stored.x1);
  int x = std::max(window.x0, stored.x0);
  const Sample* pixel = samples + (x - stored.x0) * channels;
  while (x < end) {
    const int cell = (x - window.x0) / layout_.step;
    const int cellEnd = std::min(end, window.x0 + (cell + 1) * layout_.step);
    float red = 0.0f, green = 0.0f, blue = 0.0f;
    for (; x < cellEnd; ++x, pixel += channels) {
      float scale = 1.0f;
      if (layout_.alpha >= 0) {
        const float alpha = valueOf(pixel[layout_.alpha]);
        if (alpha != 0.0f) scale = 1.0f / alpha;
      }
      red += scale * valueOf(pixel[layout_.colors[0]]);
      green += scale * valueOf(pixel[layout_.colors[1]]);
      blue += scale * valueOf(pixel[layout_.colors[2]]);
    }
    float* sum = sums + 3 * cell;
    sum[0] += red;
    sum[1] += green;
    sum[2] += blue;
  }
}

template <typename Sample>
void PreviewCanvas::addRows(const Sample* samples, std::size_t count, int y0) {
  const Rect& window = layout_.window;
  const std::size_t rowSamples =
      static_cast<std::size_t>(layout_.stored.width()) * static_cast<std::size_t>(layout_.channels);
  const std::lock_guard lock(adding_);
  for (std::size_t k = 0; k < count; ++k) {
    const int y = y0 + static_cast<int>(k);
    if (y < window.y0 || y >= window.y1) continue;
    const auto row = static_cast<std::size_t>((y - window.y0) / layout_.step);
    addRow(samples + k * rowSamples, &sums_[3 * columns_ * row]);
    ++rowsAdded_[row];
  }
}

void PreviewCanvas::add(RowSamples type, std::span<const std::byte> rows, int y0) {
  const std::size_t rowSamples =
      static_cast<std::size_t>(layout_.stored.width()) * static_cast<std::size_t>(layout_.channels);
  const auto addAs = [&]<typename Sample>(Sample) {
    addRows(reinterpret_cast<const Sample*>(rows.data()),
            rows.size() / (rowSamples * sizeof(Sample)), y0);
  };
  if (type == RowSamples::bytes) return addAs(std::uint8_t{});
  if (type == RowSamples::words) return addAs(std::uint16_t{});
  addAs(float{});
}

std::vector<char> PreviewCanvas::knownRows(Gaps gaps) const {
  std::vector<char> known(rows_);
  for (std::size_t row = 0; row < rows_; ++row) {
    const int needed = gaps == Gaps::filled ? 1 : rowsOf(row);
    known[row] = rowsAdded_[row] >= needed;
  }
  return known;
}

Status PreviewCanvas::convertRow(std::size_t row, std::array<std::vector<float>, 3>& colors) const {
  std::vector<float> rgb(3 * columns_);
  for (std::size_t x = 0; x < columns_; ++x) {
    const int left = layout_.window.width() - static_cast<int>(x) * layout_.step;
    const int pixels = std::min(layout_.step, left) * rowsAdded_[row];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t i = 3 * x + c;
      rgb[i] = sums_[3 * columns_ * row + i] / static_cast<float>(pixels);
    }
  }
  CUTIS_CHECK(toLinear_(rgb));
  for (std::size_t x = 0; x < columns_; ++x) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = rgb[3 * x + c];
      colors[c][row * columns_ + x] = std::isfinite(value) ? value : 0.0f;
    }
  }
  return {};
}

std::optional<ImagePreview> PreviewCanvas::picture(Gaps gaps, const JobContext& context) const {
  const std::vector<char> known = knownRows(gaps);
  std::array<std::vector<float>, 3> colors;
  for (std::vector<float>& channel : colors)
    channel.assign(columns_ * rows_, std::numeric_limits<float>::quiet_NaN());
  const std::size_t pieces = (rows_ + kRowsAtOnce - 1) / kRowsAtOnce;
  const auto converted = parallelFor(pieces, {context.stop, {}, {}}, [&](std::size_t i) -> Status {
    for (std::size_t row = i * kRowsAtOnce; row < std::min(rows_, (i + 1) * kRowsAtOnce); ++row) {
      if (known[row]) CUTIS_CHECK(convertRow(row, colors));
    }
    return {};
  });
  if (!converted) return std::nullopt;
  const bool isTurned = swapsSides(layout_.orientation);
  const int columns = static_cast<int>(columns_), rows = static_cast<int>(rows_);
  ImagePreview preview;
  preview.width = isTurned ? layout_.window.height() : layout_.window.width();
  preview.height = isTurned ? layout_.window.width() : layout_.window.height();
  preview.step = layout_.step;
  preview.columns = isTurned ? rows : columns;
  preview.rows = isTurned ? columns : rows;
  for (std::size_t c = 0; c < 3; ++c) {
    if (gaps == Gaps::filled) fillGaps(known, columns_, colors[c]);
    preview.colors[c].resize(colors[c].size());
    turnUpright(colors[c], columns, rows, layout_.orientation, preview.colors[c]);
  }
  return preview;
}

}  // namespace cutis
