#pragma once

// Several words as one part of a sentence.
//
// Pure functions.

#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

namespace cutis {

// "a, b and c" with " and " before the last, "a, b, c" with ", ". The words lie in a container, as
// anything that a std::string_view can be made of.
template <typename Words>
std::string wordList(const Words& words, std::string_view beforeLast) {
  const std::size_t count = std::size(words);
  std::string text;
  std::size_t i = 0;
  for (const std::string_view word : words) {
    if (i > 0) text += i + 1 == count ? beforeLast : std::string_view(", ");
    text += word;
    ++i;
  }
  return text;
}

}  // namespace cutis
