#pragma once

// How a file stores its samples.

#include <cstdint>
#include <span>
#include <string>

namespace cutis {

enum class SampleType { uint8, uint16, uint32, half, float32, float64 };

inline bool isInteger(SampleType type) {
  return type <= SampleType::uint32;
}
// "8 bit", "16 bit", "32 bit", "half", "float", "double"
std::string sampleTypeName(SampleType type);

// Each stride-th sample from the first on, unsigned integers as value / maximum.
// Precondition: `from` reaches (to.size() − 1) · stride + 1 samples.
void gatherSamples(const std::uint8_t* from, std::size_t stride, std::span<float> to);
void gatherSamples(const std::uint16_t* from, std::size_t stride, std::span<float> to);
void gatherSamples(const float* from, std::size_t stride, std::span<float> to);

// The reverse. Integers are clamped to [0, 1] and rounded to the nearest step, without dithering;
// NaN becomes 0.
void scatterSamples(std::span<const float> from, std::uint8_t* to, std::size_t stride);
void scatterSamples(std::span<const float> from, std::uint16_t* to, std::size_t stride);
void scatterSamples(std::span<const float> from, float* to, std::size_t stride);

}  // namespace cutis
