#include "src/images/codec/sample_type.h"

#include <algorithm>
#include <array>
#include <limits>

namespace cutis {
namespace {

template <typename Integer>
void gatherIntegers(const Integer* from, std::size_t stride, std::span<float> to) {
  constexpr auto maximum = static_cast<float>(std::numeric_limits<Integer>::max());
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] = static_cast<float>(from[i * stride]) / maximum;
}

template <typename Integer>
Integer quantised(float value) {
  constexpr auto maximum = static_cast<float>(std::numeric_limits<Integer>::max());
  if (!(value > 0.0f)) return 0;  // NaN, too
  return static_cast<Integer>(std::min(value, 1.0f) * maximum + 0.5f);
}

template <typename Integer>
void scatterIntegers(std::span<const float> from, Integer* to, std::size_t stride) {
  for (std::size_t i = 0; i < from.size(); ++i)
    to[i * stride] = quantised<Integer>(from[i]);
}

}  // namespace

std::string sampleTypeName(SampleType type) {
  constexpr std::array<const char*, 6> names = {"8 bit", "16 bit", "32 bit",
                                                "half",  "float",  "double"};
  return names[static_cast<std::size_t>(type)];
}

void gatherSamples(const std::uint8_t* from, std::size_t stride, std::span<float> to) {
  gatherIntegers(from, stride, to);
}
void gatherSamples(const std::uint16_t* from, std::size_t stride, std::span<float> to) {
  gatherIntegers(from, stride, to);
}
void gatherSamples(const float* from, std::size_t stride, std::span<float> to) {
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] = from[i * stride];
}

void scatterSamples(std::span<const float> from, std::uint8_t* to, std::size_t stride) {
  scatterIntegers(from, to, stride);
}
void scatterSamples(std::span<const float> from, std::uint16_t* to, std::size_t stride) {
  scatterIntegers(from, to, stride);
}
void scatterSamples(std::span<const float> from, float* to, std::size_t stride) {
  for (std::size_t i = 0; i < from.size(); ++i)
    to[i * stride] = from[i];
}

}  // namespace cutis
