#pragma once  // internal to core/simulate

// What stands behind the skin in a photograph: a dark grey-blue cloth, unevenly lit. Nothing that
// skin could be, so that it must be masked.

#include <cstdint>
#include <vector>

#include "core/base/rect.h"
#include "core/rig/rig.h"

namespace cutis {

// Thread-safe: const after construction.
class Backdrop {
 public:
  Backdrop(const Rig& rig, int width, int height, std::uint64_t seed);

  // Reflectance averaged over 400–700 nm, 0.03 to 0.08, of the pixels of rect, row by row.
  std::vector<float> level(const Rect& rect) const;
  // What level 1 reads in a channel.
  float channel(std::size_t k) const { return channels_[k]; }

 private:
  int width_, height_;
  std::uint64_t seed_;
  std::vector<float> channels_;
};

}  // namespace cutis
