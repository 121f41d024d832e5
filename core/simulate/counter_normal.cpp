#include "core/simulate/counter_normal.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/random.h"

namespace cutis {
namespace {

constexpr std::size_t kLayers = 128;
constexpr double kTail = 3.442619855899;       // where the lowest layer's box ends
constexpr double kArea = 9.91256303526217e-3;  // of every layer

struct Layers {
  Layers() {
    const auto density = [](double x) { return std::exp(-0.5 * x * x); };
    std::array<double, kLayers + 1> edge;
    edge[0] = kArea / density(kTail);
    edge[1] = kTail;
    for (std::size_t i = 2; i < kLayers; ++i) {
      edge[i] = std::sqrt(-2.0 * std::log(kArea / edge[i - 1] + density(edge[i - 1])));
    }
    edge[kLayers] = 0.0;
    for (std::size_t i = 0; i < kLayers; ++i) {
      width[i] = static_cast<float>(edge[i]);
      inside[i] = static_cast<float>(edge[i + 1] / edge[i]);
    }
    width[kLayers] = 0.0f;
  }
  std::array<float, kLayers + 1> width;  // right edge of each box
  std::array<float, kLayers> inside;     // share of it that lies under the curve altogether
};

// 24 bits, the middle of each step: never 0 or 1.
float uniform(std::uint64_t bits) {
  return (static_cast<float>(bits >> 40) + 0.5f) * 0x1p-24f;
}

float tail(std::uint64_t bits, bool negative) {
  const auto from = static_cast<float>(kTail);
  float x = 0.0f, y = 0.0f;
  do {
    bits = mixBits(bits);
    x = std::log(uniform(bits)) / from;
    bits = mixBits(bits);
    y = std::log(uniform(bits));
  } while (-2.0f * y < x * x);
  return negative ? x - from : from - x;
}

}  // namespace

float normalAt(std::uint64_t key, std::uint64_t counter) {
  static const Layers layers;
  for (std::uint64_t bits = mixBits(key + counter);; bits = mixBits(bits)) {
    const std::size_t layer = bits & (kLayers - 1);
    const float u = 2.0f * uniform(bits) - 1.0f;
    if (std::abs(u) < layers.inside[layer]) return u * layers.width[layer];
    if (layer == 0) return tail(bits, u < 0.0f);
    const float x = u * layers.width[layer];
    const auto density = [x](float edge) { return std::exp(-0.5f * (edge * edge - x * x)); };
    const float low = density(layers.width[layer]);
    const float high = density(layers.width[layer + 1]);
    bits = mixBits(bits);
    if (high + uniform(bits) * (low - high) < 1.0f) return x;
  }
}

}  // namespace cutis
