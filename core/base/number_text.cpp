#include "core/base/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace cutis {
namespace {

// Enough for the largest number with 30 decimals.
constexpr std::size_t kLongest = 384;

// Precondition: finite.
std::string converted(double value, std::chars_format format, int precision) {
  std::array<char, kLongest> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
  return {buffer.data(), end.ptr};
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string formatNumber(double value, int digits) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  return converted(value, std::chars_format::general, digits);
}

std::string fixedNumber(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  return converted(value, std::chars_format::fixed, decimals);
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

double roundedTo(double value, int digits) {
  return parseNumber(formatNumber(value, digits)).value_or(value);
}

}  // namespace cutis
