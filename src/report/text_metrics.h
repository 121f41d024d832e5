#pragma once

// How much room words take: asked by the layout, answered by whoever will draw them.

#include <string>
#include <string_view>
#include <vector>

#include "src/report/drawing.h"

namespace cutis {

// Lengths in pixels.
class TextMetrics {
 public:
  virtual ~TextMetrics() = default;

  // From the beginning of the first letter to the beginning of what would follow.
  virtual double width(std::string_view words, const TextStyle& style) const = 0;
  // Above and below the baseline, whatever the letters are.
  virtual double ascent(const TextStyle& style) const = 0;
  virtual double descent(const TextStyle& style) const = 0;

  double height(const TextStyle& style) const { return ascent(style) + descent(style); }
};

// DejaVu Sans, which is wider than most fonts: for SVG, whose viewers choose a font of their own.
const TextMetrics& printMetrics();

// Words that reach no farther than `width`, with an ellipsis where some had to go.
std::string shortened(std::string_view words, const TextStyle& style, double width,
                      const TextMetrics& metrics);
// Words as lines of at most `width`, broken at blanks. A single word may be longer.
std::vector<std::string> wrapped(std::string_view words, const TextStyle& style, double width,
                                 const TextMetrics& metrics);

}  // namespace cutis
