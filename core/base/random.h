#pragma once

// Reproducible random numbers: the same sequence on every platform and for any division of the
// work. SplitMix64 (Steele, Lea, Flood 2014). Not for security.

#include <cmath>
#include <cstdint>
#include <numbers>

namespace cutis {

inline std::uint64_t mixBits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      : state_(mixBits(seed) ^ mixBits(~stream)) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    return mixBits(state_);
  }
  // [0, 1)
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double uniform(double from, double to) { return from + (to - from) * uniform(); }
  // Mean 0, variance 1 (Box & Muller 1958).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  std::uint64_t state_;
};

}  // namespace cutis
