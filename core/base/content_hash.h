#pragma once

// Content hashes: names for cached results and fingerprints of sources. Not for security.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace cutis {

// 128 bits (XXH3), 32 lower-case hexadecimal digits.
class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  ContentHash(const ContentHash&) = delete;
  ContentHash& operator=(const ContentHash&) = delete;

  ContentHash& add(std::span<const std::byte> bytes);
  // A text is hashed with its length, so that "ab","c" and "a","bc" differ.
  ContentHash& add(std::string_view text);
  ContentHash& add(double value);
  ContentHash& add(std::span<const double> values);
  std::string digest() const;

 private:
  struct State;
  State* state_;
};

}  // namespace cutis
