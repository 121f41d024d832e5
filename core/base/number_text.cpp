#include "core/base/number_text.h"

#include <algorithm>
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

std::string percentText(double share, int digits) {
  if (!std::isfinite(share)) return "-";
  const double percent = 100.0 * share;
  const double size = std::abs(percent);
  // Digits before the point are all written; those behind it as far as they count.
  const int whole = size < 1.0 ? 0 : static_cast<int>(std::floor(std::log10(size))) + 1;
  const int zeros =
      size > 0.0 && size < 1.0 ? -static_cast<int>(std::floor(std::log10(size))) - 1 : 0;
  std::string text =
      converted(percent, std::chars_format::fixed, std::clamp(digits - whole + zeros, 0, 30));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  // 99.6 % in two digits is not all of them.
  if (percent < 100.0 && text == "100") return percentText(share, digits + 1);
  return text + " %";
}

double roundedTo(double value, int digits) {
  return parseNumber(formatNumber(value, digits)).value_or(value);
}

}  // namespace cutis
