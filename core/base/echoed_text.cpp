#include "core/base/echoed_text.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cutis {
namespace {

constexpr std::size_t kMostCharacters = 80;
constexpr std::size_t kMostOfName = 70;
constexpr char kEllipsis[] = "…";

bool continues(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

bool isControl(char byte) {
  const auto value = static_cast<unsigned char>(byte);
  return value < 0x20 || value == 0x7f;
}

std::size_t characterCount(std::string_view text) {
  std::size_t count = 0;
  for (const char byte : text)
    count += continues(byte) ? 0 : 1;
  return count;
}

// Where the character with this number begins.
std::size_t byteOf(std::string_view text, std::size_t character) {
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    if (continues(text[at])) continue;
    if (character-- == 0) break;
  }
  return at;
}

// With so many characters of the end, if it is too long.
std::string cutTo(std::string_view text, std::size_t tail) {
  const std::size_t count = characterCount(text);
  if (count <= kMostCharacters) return onOneLine(std::string(text));
  const std::size_t head = kMostCharacters - 1 - tail;
  return onOneLine(std::string(text.substr(0, byteOf(text, head))) + kEllipsis +
                   std::string(text.substr(byteOf(text, count - tail))));
}

}  // namespace

std::string onOneLine(std::string text) {
  std::replace_if(text.begin(), text.end(), isControl, ' ');
  return text;
}

std::string shortened(std::string_view text) {
  return cutTo(text, kMostCharacters / 2 - 1);
}

std::string shortenedPlace(std::string_view place) {
  const std::size_t slash = place.rfind('/');
  const std::string_view name = slash == std::string_view::npos ? place : place.substr(slash);
  return cutTo(place, std::clamp(characterCount(name), kMostCharacters / 2 - 1, kMostOfName));
}

std::string inQuotes(std::string_view text) {
  return "'" + shortened(text) + "'";
}

}  // namespace cutis
