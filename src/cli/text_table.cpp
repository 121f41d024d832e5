#include "src/cli/text_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace cutis {
namespace {

std::size_t width(const std::string& text) {
  // Bytes that continue a character start with the bits 10.
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

std::string converted(double value, std::chars_format format, int precision) {
  std::array<char, 64> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
  return end.ec == std::errc() ? std::string(buffer.data(), end.ptr) : std::string("-");
}

}  // namespace

std::string TextTable::text() const {
  std::vector<std::size_t> widths(rows_.front().size());
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], width(row[i]));
  }
  std::string text;
  for (const auto& row : rows_) {
    std::string line = "  ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string blanks(widths[i] - width(row[i]), ' ');
      if (i > 0) line += "  ";
      line += i < leftColumns_ ? row[i] + blanks : blanks + row[i];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string shortScientific(double value) {
  if (value == 0.0) return "0";
  if (!std::isfinite(value)) return "-";
  std::string text = converted(value, std::chars_format::scientific, 2);
  // "3.82e-06"
  const auto digits = text.find_first_of("+-", text.find('e')) + 1;
  while (digits + 1 < text.size() && text[digits] == '0')
    text.erase(digits, 1);
  return text;
}

std::string fixedNumber(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  return converted(value, std::chars_format::fixed, decimals);
}

}  // namespace cutis
