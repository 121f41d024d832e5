#include "src/files/spectra/percent_words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "src/files/spectra/wavelength_text.h"

namespace cutis {
namespace {

// What a line speaks of, in lower case.
constexpr std::array<std::string_view, 7> kOfValues = {"reflect", "remission", "unit",  "y axis",
                                                       "yaxis",   "y-axis",    "values"};

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

// A number before the sign counts something, and one behind it is an escape: "%20".
bool countsNothing(std::string_view text, std::size_t begin, std::size_t end) {
  const std::size_t before = begin == 0 ? begin : text.find_last_not_of(" \t", begin - 1);
  if (begin > 0 && before != std::string_view::npos && isDigit(text[before])) return false;
  return end == text.size() || !isDigit(text[end]);
}

bool speaksOfValues(std::string_view line) {
  return std::any_of(kOfValues.begin(), kOfValues.end(), [&](std::string_view word) {
    return line.find(word) != std::string_view::npos;
  });
}

}  // namespace

bool declaresPercent(std::string_view heading) {
  const std::string lower = loweredText(heading);
  for (const std::string_view sign : {std::string_view("%"), std::string_view("percent")}) {
    for (std::size_t at = lower.find(sign); at != std::string::npos; at = lower.find(sign, at + 1))
      if (countsNothing(lower, at, at + sign.size())) return true;
  }
  return false;
}

std::optional<int> percentLineAbove(std::string_view text, int endLine) {
  for (int line = 1; line < endLine && !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string lower = loweredText(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (speaksOfValues(lower) && declaresPercent(lower)) return line;
  }
  return std::nullopt;
}

}  // namespace cutis
