#pragma once

// Panels to lay out, and what a drawing holds.

#include <string>
#include <vector>

#include "src/report/plot/page.h"
#include "src/report/text_metrics.h"

namespace cutis::test {

// Curves, points with labels and bars, a level, shades, a legend: some of all there is.
Panel richPanel();

// What the words of a drawing cover, about as high as capitals are.
struct TextBox {
  std::string words;
  Box box;
};
std::vector<TextBox> textBoxes(const Drawing& drawing, const TextMetrics& metrics);

// One sentence for every word that leaves the drawing or lies on another; empty if all is well.
std::string untidyWords(const Drawing& drawing, const TextMetrics& metrics);

}  // namespace cutis::test
