#include "src/files/spectra/text_encoding.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace cutis {
namespace {

constexpr std::size_t kLookedAt = 4096;
constexpr char32_t kReplacement = 0xFFFD;

enum class ByteOrder { little, big };

std::optional<ByteOrder> utf16OrderOf(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return ByteOrder::little;
  if (bytes.starts_with("\xFE\xFF")) return ByteOrder::big;
  const std::string_view head = bytes.substr(0, kLookedAt);
  std::size_t zeros[2] = {};
  for (std::size_t i = 0; i < head.size(); ++i)
    zeros[i % 2] += head[i] == '\0' ? 1 : 0;
  // Digits and separators have a zero in every unit; binary data has zeros on both sides.
  const std::size_t many = head.size() / 4;
  if (zeros[1] > many && zeros[0] == 0) return ByteOrder::little;
  if (zeros[0] > many && zeros[1] == 0) return ByteOrder::big;
  return std::nullopt;
}

void appendUtf8(std::string& text, char32_t code) {
  const auto add = [&](char32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | code >> 6);
    add(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    add(0xE0 | code >> 12);
    add(0x80 | (code >> 6 & 0x3F));
    add(0x80 | (code & 0x3F));
  } else {
    add(0xF0 | code >> 18);
    add(0x80 | (code >> 12 & 0x3F));
    add(0x80 | (code >> 6 & 0x3F));
    add(0x80 | (code & 0x3F));
  }
}

std::string utf8Of(std::string_view bytes, ByteOrder order) {
  const auto unitAt = [&](std::size_t i) {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<char32_t>(order == ByteOrder::little ? first | second << 8
                                                            : first << 8 | second);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const char32_t unit = unitAt(i);
    if (i == 0 && unit == 0xFEFF) continue;
    if (unit < 0xD800 || unit > 0xDFFF) {
      appendUtf8(text, unit);
      continue;
    }
    const char32_t low = i + 3 < bytes.size() ? unitAt(i + 2) : 0;
    if (unit < 0xDC00 && low >= 0xDC00 && low <= 0xDFFF) {
      appendUtf8(text, 0x10000 + ((unit - 0xD800) << 10) + (low - 0xDC00));
      i += 2;
    } else {
      appendUtf8(text, kReplacement);
    }
  }
  return text;
}

bool isControl(char c) {
  const auto code = static_cast<unsigned char>(c);
  constexpr std::string_view kUsual = "\t\n\v\f\r\x1A";
  return code < 0x20 && kUsual.find(c) == std::string_view::npos;
}

// What a file is that is no text to take spectra from; empty for texts.
std::string_view foreignKind(std::string_view text) {
  if (text.starts_with("PK\x03\x04") || text.starts_with("\xD0\xCF\x11\xE0")) {
    return "this is a spreadsheet or an archive; save the table as CSV";
  }
  const std::string_view head = text.substr(0, kLookedAt);
  const auto first = head.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && head[first] == '<') {
    return "this is XML or HTML; export the spectra as CSV or as CGATS text";
  }
  if (std::any_of(head.begin(), head.end(), isControl)) {
    return "this is no text but a binary file; export the spectra as CSV";
  }
  return {};
}

}  // namespace

Result<std::string> decodedText(std::string bytes, const std::string& place) {
  if (const auto order = utf16OrderOf(bytes)) bytes = utf8Of(bytes, *order);
  if (const std::string_view kind = foreignKind(bytes); !kind.empty()) {
    return inputError(place, std::string(kind));
  }
  return bytes;
}

}  // namespace cutis
