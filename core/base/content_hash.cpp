#include "core/base/content_hash.h"

#include <cstdint>
#include <xxhash.h>

namespace cutis {

struct ContentHash::State {
  XXH3_state_t* xxh = XXH3_createState();
};

ContentHash::ContentHash() : state_(new State) {
  XXH3_128bits_reset(state_->xxh);
}

ContentHash::~ContentHash() {
  XXH3_freeState(state_->xxh);
  delete state_;
}

ContentHash& ContentHash::add(std::span<const std::byte> bytes) {
  XXH3_128bits_update(state_->xxh, bytes.data(), bytes.size());
  return *this;
}

ContentHash& ContentHash::add(std::string_view text) {
  const std::uint64_t length = text.size();
  XXH3_128bits_update(state_->xxh, &length, sizeof length);
  XXH3_128bits_update(state_->xxh, text.data(), text.size());
  return *this;
}

ContentHash& ContentHash::add(double value) {
  return add(std::span<const double>(&value, 1));
}

ContentHash& ContentHash::add(std::span<const double> values) {
  return add(std::as_bytes(values));
}

std::string ContentHash::digest() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_->xxh);
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, hash);
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : canonical.digest) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

}  // namespace cutis
