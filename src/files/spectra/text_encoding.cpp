#include "src/files/spectra/text_encoding.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

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

// How many bytes the character has that begins here; 0 if it is none (RFC 3629, §4).
std::size_t characterAt(std::string_view bytes, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + length > bytes.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const unsigned second = byte(1);
  const bool tooLong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool isSurrogate = first == 0xED && second > 0x9F;
  const bool isBeyond = first == 0xF4 && second > 0x8F;
  return tooLong || isSurrogate || isBeyond ? 0 : length;
}

bool isUtf8(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = characterAt(bytes, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

// As the WHATWG Encoding Standard has it: bytes without a character are controls.
std::string ofWindows1252(std::string_view bytes) {
  constexpr std::array<char16_t, 32> kFrom0x80 = {
      0x20AC, 0x0081, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
      0x2039, 0x0152, 0x008D, 0x017D, 0x008F, 0x0090, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
      0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x009D, 0x017E, 0x0178};
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 16);
  for (const char c : bytes) {
    const auto code = static_cast<unsigned char>(c);
    const bool isOwn = code >= 0x80 && code < 0xA0;
    appendUtf8(text, isOwn ? char32_t{kFrom0x80[code - 0x80U]} : char32_t{code});
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

Result<DecodedText> decodedText(std::string bytes, const std::string& place) {
  if (const auto order = utf16OrderOf(bytes)) bytes = utf8Of(bytes, *order);
  if (const std::string_view kind = foreignKind(bytes); !kind.empty()) {
    return inputError(place, std::string(kind));
  }
  if (isUtf8(bytes)) return DecodedText{std::move(bytes), false};
  return DecodedText{ofWindows1252(bytes), true};
}

}  // namespace cutis
