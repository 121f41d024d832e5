#include "src/report/text_metrics.h"

#include <algorithm>
#include <array>

namespace cutis {
namespace {

// From the blank to the tilde, in thousandths of an em.
constexpr std::array<short, 95> kWidths = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr double kOtherWidth = 838;  // signs such as ≤; letters with accents are narrower
constexpr double kBoldWidth = 1.15;
constexpr double kAscent = 0.93, kDescent = 0.24;

bool continuesCharacter(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

class PrintMetrics : public TextMetrics {
 public:
  double width(std::string_view words, const TextStyle& style) const override {
    double width = 0.0;
    for (const char c : words) {
      if (continuesCharacter(c)) continue;
      const auto index = static_cast<std::size_t>(static_cast<unsigned char>(c)) - 32;
      width += index < kWidths.size() ? kWidths[index] : kOtherWidth;
    }
    return 1e-3 * width * style.size * (style.bold ? kBoldWidth : 1.0);
  }
  double ascent(const TextStyle& style) const override { return kAscent * style.size; }
  double descent(const TextStyle& style) const override { return kDescent * style.size; }
};

}  // namespace

const TextMetrics& printMetrics() {
  static const PrintMetrics metrics;
  return metrics;
}

std::string shortened(std::string_view words, const TextStyle& style, double width,
                      const TextMetrics& metrics) {
  if (metrics.width(words, style) <= width) return std::string(words);
  std::string text(words);
  while (!text.empty() && metrics.width(text + "…", style) > width) {
    while (text.size() > 1 && continuesCharacter(text.back()))
      text.pop_back();
    text.pop_back();
  }
  return text + "…";
}

std::vector<std::string> wrapped(std::string_view words, const TextStyle& style, double width,
                                 const TextMetrics& metrics) {
  std::vector<std::string> lines(1);
  for (std::size_t from = 0; from < words.size();) {
    const std::size_t end = std::min(words.find(' ', from), words.size());
    const std::string word(words.substr(from, end - from));
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (metrics.width(longer, style) > width && !lines.back().empty()) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
    from = end + 1;
  }
  return lines;
}

}  // namespace cutis
