#pragma once

// IEEE 754 binary16 in memory, float in arithmetic. Conversion rounds to nearest even; values
// beyond ±65504 become infinite; NaN stays NaN, and is the
// same one with either sign whatever it was. Thread-safe.

#include <cstdint>
#include <span>

namespace cutis {

// Precondition: both spans have the same length.
void convertHalfToFloat(std::span<const std::uint16_t> from, std::span<float> to);
void convertFloatToHalf(std::span<const float> from, std::span<std::uint16_t> to);

}  // namespace cutis
