#pragma once

// What a view can say of a sample beside its value (core/analyse/skin_likeness.h): a set of bits.

#include <array>
#include <cstdint>

namespace cutis {

enum PixelMark : std::uint8_t {
  kNotSkin = 1,      // no skin of the profile looks like it
  kAtBound = 2,      // the parameter stands at an end of its range
  kMostlyPrior = 4,  // the photographs say little about the parameter
};

inline constexpr std::array<PixelMark, 3> kPixelMarks = {kNotSkin, kAtBound, kMostlyPrior};

using PixelMarks = std::uint8_t;  // of PixelMark

}  // namespace cutis
