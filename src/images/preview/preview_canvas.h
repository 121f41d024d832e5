#pragma once  // internal to src/images/preview

// A picture made smaller while its rows come in, in any order.
//
// Each pixel is the mean of a square of step × step pixels of what the file stores: numbers that
// encode light by a curve are averaged as they are, so that only what is shown has to be converted.
// Colours that are multiplied by alpha are divided by it first, as where all of the picture is
// read. What is not finite counts as 0, and so does what lies around the stored pixels.

#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/rect.h"
#include "src/color/color_space.h"
#include "src/images/pixels/orientation.h"
#include "src/images/preview/image_preview.h"

namespace cutis {

// What rows consist of; integers stand for value / maximum.
enum class RowSamples { bytes, words, floats };

struct CanvasLayout {
  // The picture as it lies in the file and what of it is stored, as of ImagePart.
  Rect window;
  Rect stored;
  Orientation orientation = Orientation::upright;
  int channels = 3;                       // of a stored pixel
  std::array<int, 3> colors = {0, 1, 2};  // among them; grey is three times the same
  int alpha = -1;                         // that colours are multiplied by; -1: they are not
  int step = 1;
};

class PreviewCanvas {
 public:
  PreviewCanvas(const CanvasLayout& layout, ColorConverter toLinear);

  // Whole stored rows from this one on. Several threads may add rows, each of them once.
  void add(RowSamples type, std::span<const std::byte> rows, int y0);

  // Rows of which nothing or not all was added: not read yet, or between those that were.
  enum class Gaps { empty, filled };
  // Upright. Nothing if it cannot be converted, or when asked to stop.
  std::optional<ImagePreview> picture(Gaps gaps, const JobContext& context) const;

 private:
  template <typename Sample>
  void addRows(const Sample* samples, std::size_t count, int y0);
  template <typename Sample>
  void addRow(const Sample* samples, float* sums) const;
  std::vector<char> knownRows(Gaps gaps) const;
  Status convertRow(std::size_t row, std::array<std::vector<float>, 3>& colors) const;
  int rowsOf(std::size_t row) const;

  CanvasLayout layout_;
  ColorConverter toLinear_;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::mutex adding_;
  std::vector<float> sums_;     // of red, green and blue beside each other, row by row
  std::vector<int> rowsAdded_;  // to each row, what is not stored included
};

}  // namespace cutis
